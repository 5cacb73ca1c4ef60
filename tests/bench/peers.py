"""Times of other libraries on one mesh, for `npm run bench -- --parts peers`.

peers.py TASK.json RESULT.json. The task has the points and faces of a mesh, and the call. The result has
the milliseconds of single steps, or the shapes made in several ways. Single-threaded: the caller sets
OMP_NUM_THREADS.
"""

import importlib.metadata
import json
import sys
import time

import numpy


def timed(call):
    """Result of the call, and its milliseconds."""
    start = time.perf_counter()
    value = call()
    return value, 1e3 * (time.perf_counter() - start)


def repeated(call):
    """Result of the call, and the milliseconds of three after a first one."""
    runs = [timed(call) for _ in range(4)]
    return runs[0][0], [ms for _, ms in runs[1:]]


def differences(run, steps):
    """Milliseconds of one iteration, as the difference of runs of two lengths, three times."""
    run(1)
    return {"steps": [(run(1 + steps) - run(1)) / steps for _ in range(3)]}


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


def compas_circles(points, faces, task):
    """Circles and closeness to the initial positions: one iteration per call."""
    solver = compas_solver(points, faces, "circle", 5.0, 10.0)
    steps = [timed(lambda: solver.solve(1))[1] for _ in range(21)]
    return {"steps": steps[1:]}


def libigl_arap(points, faces, task):
    """As-rigid-as-possible with fixed handles, the middle one lifted: whole runs."""
    import igl

    handles = numpy.array(task["handles"]["vertices"], dtype=numpy.int32)
    targets = numpy.array(task["handles"]["targets"])
    data = igl.ARAPData()
    data.energy = igl.ARAP_ENERGY_TYPE_SPOKES
    igl.arap_precomputation(points, faces, 3, handles, data)

    def run(iterations):
        data.max_iter = iterations
        return timed(lambda: igl.arap_solve(targets, data, points))[1]

    return differences(run, 5)


def planarized(points, faces, iterations):
    """Planes for quads, and the milliseconds; with threshold 0 all iterations are made."""
    import igl

    return timed(lambda: igl.planarize_quad_mesh(points, faces, iterations, 0.0))


def libigl_planes(points, faces, task):
    """Planes for quads; the matrix is factored in the call, so runs of two lengths are compared."""
    return differences(lambda count: planarized(points, faces, count)[1], 2)


def libigl_lscm(points, faces, task):
    """Least-squares conformal map with two fixed vertices: whole calls."""
    import igl

    ends = numpy.array([0, len(points) - 1])
    width = float(numpy.linalg.norm(points[ends[1]] - points[ends[0]]))
    at = numpy.array([[0.0, 0.0], [width, 0.0]])
    return {"steps": repeated(lambda: igl.lscm(points, faces, ends, at))[1]}


def pymeshlab_lscm(points, faces, task):
    """Least-squares conformal map with two fixed vertices: whole filters."""
    import pymeshlab

    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(points, faces))
    name = "compute_texcoord_parametrization_least_squares_conformal_maps"
    return {"steps": repeated(lambda: meshes.apply_filter(name))[1]}


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


def compas_exact(points, faces, task):
    """Circles or planes, 2000 iterations in each way above; those that collapse the mesh are left out."""

    def run(weights, closeness):
        shape = points
        for weight in weights:
            solver = compas_solver(shape, faces, task["kind"], weight, closeness)
            solver.solve(2000 // len(weights))
            shape = numpy.array(solver.get_points()).reshape(3, -1, order="F").T
        return shape

    ways = []
    for way, setting in COMPAS_WAYS.items():
        shape, ms = timed(lambda: run(*setting))
        # A collapsed mesh meets every constraint.
        if (lengths(shape, faces) > 0.01 * lengths(points, faces)).all():
            ways.append({"way": way, "ms": ms, "shape": shape.tolist()})
    return {"ways": ways}


def lengths(points, faces):
    """The edge lengths of each face; none is greater than another if they are not numbers."""
    return numpy.linalg.norm(points[faces] - points[numpy.roll(faces, 1, axis=1)], axis=2)


def libigl_exact(points, faces, task):
    """Planes, in one way."""
    shape, ms = planarized(points, faces, 100)
    return {"ways": [{"way": "planarize_quad_mesh, 100 iterations", "ms": ms, "shape": shape.tolist()}]}


def pynanoinstantmeshes(points, faces, task):
    """Quads in four directions; it divides each into four at last."""
    from pynanoinstantmeshes import remesh

    given = points.astype(numpy.float32), faces.astype(numpy.uint32)
    count = task["panels"] // 4
    made, steps = repeated(lambda: remesh(*given, count, align_to_boundaries=True, deterministic=True))
    points, faces = made
    return {"steps": steps, "points": points.tolist(), "faces": faces.tolist()}


def pyQuadriFlow(points, faces, task):
    """Quads, the boundary kept."""
    from pyQuadriFlow.pyQuadriFlow import pyquadriflow

    given = points.tolist(), faces.tolist()
    made, steps = repeated(lambda: pyquadriflow(task["panels"], 0, *given, False, True, False, False, False))
    return {"steps": steps, "points": made["vertices"], "faces": made["faces"]}


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        asked = json.load(file)
    mesh = [numpy.array(asked[name]) for name in ("points", "faces")]
    version = importlib.metadata.version(asked["library"])
    result = globals()[asked["call"]](*mesh, asked)
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        json.dump({"version": version, **result}, file)
