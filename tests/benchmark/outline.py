"""Quad meshes of an outline (.geo) by the gmsh on the PATH."""
import process

LIMIT = 300  # seconds for one mesh

ALGORITHMS = {6: "frontal", 8: "frontal for quads", 9: "packing of parallelograms"}
RECOMBINATIONS = {1: "Blossom, subdivided", 2: "simple full-quad", 3: "Blossom full-quad"}


def mesh(outline, scale, algorithm, recombination, path):
    """Recombination 1 leaves triangles, so all is subdivided, which halves the edges as 2 and 3 do."""
    subdivided = recombination == 1
    # Options in the outline win over those of the command line, so they are set after it.
    model = path.with_suffix(".geo")
    model.write_text(
        f'Include "{outline.resolve()}";\n'
        "Mesh.RecombineAll = 1;\n"
        f"Mesh.Algorithm = {algorithm};\n"
        f"Mesh.RecombinationAlgorithm = {recombination};\n"
        f"Mesh.SubdivisionAlgorithm = {int(subdivided)};\n"
        "Mesh.Binary = 0;\n"
        "Mesh.MshFileVersion = 2.2;\n", encoding="utf-8")
    path.unlink(missing_ok=True)
    run = process.run(["gmsh", "-2", model, "-clscale", scale * (2 if subdivided else 1),
                       "-o", path, "-v", "2"], LIMIT)
    if not run.fault and not path.exists():
        run.fault = "no mesh written"
    return run


def version():
    return process.run(["gmsh", "--version"], LIMIT).output.strip()


def is_without_blossom(run):
    """gmsh cannot match an odd number of triangles, and then pairs them by a simple rule."""
    return "Cannot apply Blossom" in run.output


def is_all_quads(path):
    """The second number of an element in MSH 2.2 is its kind, 2 for a triangle."""
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.startswith("$Elements"):
                break
        return not any(line.split()[1:2] == ["2"] for line in file)


def mesh_all_quads(outline, scale, path):
    """Frontal and Blossom full-quad. At some sizes that leaves triangles or does without Blossom, which
    gives a much worse mesh: then a little finer. The scale taken is returned with the run."""
    for _ in range(20):
        run = mesh(outline, scale, 6, 3, path)
        if run.fault:
            break
        if is_all_quads(path) and not is_without_blossom(run):
            break
        run.fault = "triangles left, or Blossom not applied"
        scale = round(0.97 * scale, 4)
    return run, scale
