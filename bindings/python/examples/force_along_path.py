"""Slides one model past another and plots the force on it.

    python force_along_path.py crankshaft_45k.glb gear_6k.glb --plot force.png"""

import argparse

import palpate

STEPS = 200


def forces_along(scene, tool, begin, end):
    """(millimetres moved, force) for each step on the straight way between two positions."""
    rows = []
    for step in range(STEPS + 1):
        share = step / STEPS
        position = [a + share * (b - a) for a, b in zip(begin, end)]
        tool.pose = (*position, -0.5, 0, 0, 0.866)
        contacts = scene.step()
        rows.append((1000 * share * (end[0] - begin[0]), contacts.wrench.force))
    return rows


def plot(rows, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    moved, forces = zip(*rows)
    for axis, name in enumerate("xyz"):
        pyplot.plot(moved, [force[axis] for force in forces], label=name)
    pyplot.xlabel("moved, mm")
    pyplot.ylabel("force on the tool, N")
    pyplot.legend()
    pyplot.savefig(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("body")
    parser.add_argument("tool")
    parser.add_argument("--plot", help="an image file, written with matplotlib")
    arguments = parser.parse_args()
    scene = palpate.Scene(cutoff=0.003, stiffness=1000)
    scene.add(palpate.Model.load(arguments.body))
    tool = scene.add(palpate.Model.load(arguments.tool), kind="tool")
    rows = forces_along(scene, tool, (-0.015, 0.0703, -0.02), (0.005, 0.0703, -0.02))
    strongest = max(rows, key=lambda row: sum(part * part for part in row[1]))
    print("strongest after {:.1f} mm: {:.2f} {:.2f} {:.2f} N".format(strongest[0], *strongest[1]))
    if arguments.plot:
        plot(rows, arguments.plot)


if __name__ == "__main__":
    main()
