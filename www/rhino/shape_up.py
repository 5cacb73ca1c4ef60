"""Makes the panels of a mesh circular or flat, with the command `shape-up`.

In Python: solve(vertices, faces). For a file: python shape_up.py roof.obj out.obj"""
import json, os, subprocess, sys, tempfile


def solve_file(source, out, panels="circle", within="auto", program="shape-up"):
    """Writes the mesh file `source`, solved, to `out`; returns the report."""
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        command = [program, "solve", source, "--panels", panels, "--within", str(within)]
        try:
            done = subprocess.run(
                command + ["--out", out, "--report", report],
                stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8",
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0))  # for Windows
        except FileNotFoundError:
            raise RuntimeError(f"{program} was not found: give its full path as `program`")
        if done.returncode != 0:  # The message, without the usage that may follow it.
            raise RuntimeError(done.stderr.split("\n\n")[0].strip() or str(done))
        with open(report, encoding="utf-8") as file:
            return json.load(file)


def solve(vertices, faces, panels="circle", within="auto", program="shape-up", units=""):
    """Returns the solved vertices in their order, and the report, which has what became
    of the panels in ["verdict"]["words"]. Faces have vertex numbers from 0."""
    with tempfile.TemporaryDirectory() as folder:
        source, out = (os.path.join(folder, name) for name in ("in.obj", "out.obj"))
        with open(source, "w", encoding="utf-8") as file:
            file.write(f"# units: {units}\n")
            for point in vertices:
                print("v", *(repr(float(x)) for x in point), file=file)
            for face in faces:
                if min(face) < 0:
                    raise ValueError(f"expected vertex numbers from 0, not {list(face)}")
                print("f", *(int(vertex) + 1 for vertex in face), file=file)
        report = solve_file(source, out, panels, within, program)
        with open(out, encoding="utf-8") as file:
            rows = [line.split()[1:] for line in file if line.startswith("v ")]
    return [tuple(map(float, row)) for row in rows], report


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        sys.stdout.reconfigure(encoding="utf-8")
        print(solve_file(*sys.argv[1:])["verdict"]["words"])
    except (OSError, RuntimeError) as error:
        sys.exit(str(error))
