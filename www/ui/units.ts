/** The units of length. `src/scene/units.rs` is their table, and its test writes this file:
 * `UPDATE=1 cargo test --lib units`. */
export const UNITS = [
  { symbol: 'm', metres: 1, rhino: 'Meters' },
  { symbol: 'cm', metres: 0.01, rhino: 'Centimeters' },
  { symbol: 'mm', metres: 0.001, rhino: 'Millimeters' },
  { symbol: 'ft', metres: 0.3048, rhino: 'Feet' },
  { symbol: 'in', metres: 0.0254, rhino: 'Inches' },
];
