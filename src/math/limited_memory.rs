//! The inverse of a Hessian from the last steps of a descent: limited-memory BFGS (Nocedal and Wright,
//! *Numerical Optimization*, 2006, algorithm 7.4).

/// The last steps with the changes of the gradient along them. Without any, the inverse is the identity.
#[derive(Clone, Debug)]
pub struct LimitedMemory {
    /// Step, change and the reciprocal of their product, the oldest first.
    pairs: Vec<(Vec<f64>, Vec<f64>, f64)>,
    most: usize,
}

impl LimitedMemory {
    /// A memory of at most this many steps.
    pub fn of(most: usize) -> LimitedMemory {
        LimitedMemory { pairs: Vec::new(), most }
    }

    /// Whether there is no step in it.
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    /// Removes all steps.
    pub fn clear(&mut self) {
        self.pairs.clear();
    }

    /// Adds a step and the change of the gradient along it; their product must be positive.
    pub fn push(&mut self, step: Vec<f64>, change: Vec<f64>) {
        if self.pairs.len() == self.most {
            self.pairs.remove(0);
        }
        let inverse = 1.0 / inner_product(&step, &change);
        self.pairs.push((step, change, inverse));
    }

    /// Multiplies a vector by the inverse, in two loops over the steps.
    pub fn apply(&self, vector: &mut [f64]) {
        let mut amounts = Vec::with_capacity(self.pairs.len());
        for (step, change, inverse) in self.pairs.iter().rev() {
            let amount = inverse * inner_product(step, vector);
            add_scaled(vector, -amount, change);
            amounts.push(amount);
        }
        if let Some((_, change, inverse)) = self.pairs.last() {
            let scale = 1.0 / (inverse * inner_product(change, change));
            vector.iter_mut().for_each(|v| *v *= scale);
        }
        for ((step, change, inverse), amount) in self.pairs.iter().zip(amounts.into_iter().rev()) {
            let other = inverse * inner_product(change, vector);
            add_scaled(vector, amount - other, step);
        }
    }
}

/// `y += factor * x`.
pub fn add_scaled(y: &mut [f64], factor: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += factor * x;
    }
}

/// The inner product, summed in the same order on every machine.
pub fn inner_product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
