"""Times of other libraries on one mesh, for `npm run bench -- --parts peers`.

peers.py TASK.json RESULT.json. The task gives an OBJ file of quads or triangles and the call; the result is
in milliseconds. Single-threaded: the caller sets OMP_NUM_THREADS.
"""

import json
import sys
import time

import numpy


def read_obj(path):
    """Vertices and faces of an OBJ file that contains nothing else."""
    with open(path, encoding="utf-8") as file:
        lines = [line.split() for line in file]
    vertices = [[float(part) for part in rest] for word, *rest in lines if word == "v"]
    faces = [[int(part) - 1 for part in rest] for word, *rest in lines if word == "f"]
    return numpy.array(vertices), numpy.array(faces)


def timed(call):
    """Result of the call, and its milliseconds."""
    start = time.perf_counter()
    value = call()
    return value, 1e3 * (time.perf_counter() - start)


def differences(run, steps):
    """Milliseconds of one iteration, as the difference of runs of two lengths, three times."""
    run(1)
    return [(run(1 + steps) - run(1)) / steps for _ in range(3)]


def compas_solver(points, faces, kind, weight, closeness):
    """Circles or planes for all faces, and closeness to the points."""
    from compas_shapeop._shapeop import SolverWrapper

    solver = SolverWrapper()
    solver.set_points(numpy.asfortranarray(points.T))
    for vertex in range(len(points) if closeness > 0.0 else 0):
        solver.add_closeness_constraint(vertex, closeness)
    add = solver.add_circle_constraint if kind == "circle" else solver.add_plane_constraint
    for face in faces.tolist():
        add(face, weight)
    solver.initialize(False, 1.0, 1.0, 1.0)
    return solver


def compas_circles(task):
    """Circles and closeness to the initial positions: one iteration per call."""
    solver = compas_solver(*read_obj(task["mesh"]), "circle", 5.0, 10.0)
    steps = [timed(lambda: solver.solve(1))[1] for _ in range(task["iterations"])]
    return {"steps": steps[1:]}


def libigl_arap(task):
    """As-rigid-as-possible with fixed handles, the middle one lifted: whole runs."""
    import igl

    vertices, faces = read_obj(task["mesh"])
    handles = numpy.array(task["handles"]["vertices"], dtype=numpy.int32)
    targets = numpy.array(task["handles"]["targets"])
    data = igl.ARAPData()
    data.energy = igl.ARAP_ENERGY_TYPE_SPOKES
    igl.arap_precomputation(vertices, faces, 3, handles, data)

    def run(iterations):
        data.max_iter = iterations
        return timed(lambda: igl.arap_solve(targets, data, vertices))[1]

    return {"steps": differences(run, task["iterations"])}


def libigl_planes(task):
    """Planes for quads; the matrix is factored in the call, so runs of two lengths are compared."""
    import igl

    vertices, faces = read_obj(task["mesh"])

    def run(iterations):
        return timed(lambda: igl.planarize_quad_mesh(vertices, faces, iterations, 0.0))[1]

    return {"steps": differences(run, task["iterations"])}


def libigl_lscm(task):
    """Least-squares conformal map with two fixed vertices: whole calls."""
    import igl

    vertices, faces = read_obj(task["mesh"])
    ends = numpy.array([0, len(vertices) - 1])
    width = float(numpy.linalg.norm(vertices[ends[1]] - vertices[ends[0]]))
    at = numpy.array([[0.0, 0.0], [width, 0.0]])
    runs = [timed(lambda: igl.lscm(vertices, faces, ends, at))[1] for _ in range(3)]
    return {"steps": runs[1:]}


# Weights of the circles or planes, used in sequence, each starting at the previous shape, and the
# weight of closeness.
COMPAS_WAYS = {
    "weight 10, closeness 10": ([10.0], 10.0),
    "weight 1,000, closeness 10": ([1e3], 10.0),
    "weight 1,000,000, closeness 10": ([1e6], 10.0),
    "weight 1,000, closeness 0.001": ([1e3], 1e-3),
    "weight 10 to 1,000,000, closeness 0.001": ([10.0**power for power in range(1, 7)], 1e-3),
    "no closeness": ([1.0], 0.0),
}


def compas_exact(task):
    """Circles or planes by their weight against closeness, for each setting above: the least remaining distance,
    its setting, and the total time of that setting."""
    vertices, faces = read_obj(task["mesh"])

    def run(weights, closeness):
        points = vertices
        for weight in weights:
            solver = compas_solver(points, faces, task["kind"], weight, closeness)
            solver.solve(max(1, task["iterations"] // len(weights)))
            points = numpy.array(solver.get_points()).reshape(3, -1, order="F").T
        return points

    tried = []
    for way, setting in COMPAS_WAYS.items():
        points, ms = timed(lambda: run(*setting))
        distance = worst(points, faces, task["kind"])
        if numpy.isfinite(distance) and not collapsed(points, vertices, faces):
            tried.append({"ms": ms, "distance": distance, "way": way})
    return min(tried, key=lambda one: one["distance"])


def collapsed(points, before, faces):
    """Whether an edge has shrunk below a hundredth of its length: a collapsed mesh meets every constraint."""

    def lengths(points):
        return numpy.linalg.norm(points[faces] - points[numpy.roll(faces, 1, axis=1)], axis=2)

    return bool((lengths(points) < 0.01 * lengths(before)).any())


def libigl_exact(task):
    """Planes; with threshold 0 all iterations are made."""
    import igl

    vertices, faces = read_obj(task["mesh"])
    points, ms = timed(lambda: igl.planarize_quad_mesh(vertices, faces, task["iterations"], 0.0))
    way = f"planarize_quad_mesh, {task['iterations']} iterations"
    return {"ms": ms, "distance": worst(points, faces, task["kind"]), "way": way}


def worst(points, faces, kind):
    """Greatest distance of a corner to the least-squares plane of its quad, or to the algebraic circle in it."""
    corners = points[faces]
    away = corners - corners.mean(axis=1, keepdims=True)
    axes = numpy.linalg.svd(away)[2]
    along = away @ axes.transpose(0, 2, 1)
    height = along[:, :, 2]
    if kind == "plane":
        return float(numpy.abs(height).max())
    flat = along[:, :, :2]
    squares = (flat**2).sum(axis=2)
    rows = numpy.concatenate([2 * flat, numpy.ones_like(height)[:, :, None]], axis=2)
    found = (numpy.linalg.pinv(rows) @ squares[:, :, None])[:, :, 0]
    centre = found[:, None, :2]
    radius = numpy.sqrt(found[:, 2] + (found[:, :2] ** 2).sum(axis=1))
    off = numpy.linalg.norm(flat - centre, axis=2) - radius[:, None]
    return float(numpy.hypot(off, height).max())


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        asked = json.load(file)
    result = globals()[asked["call"]](asked)
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        json.dump(result, file)
