"""figures.py CSV FOLDER: draws time against error, growth, and the ratios to FCL."""

import sys
from pathlib import Path

from results import Results
from svg import COLOURS, Chart, Drawing

NO_ERROR = 1e-4  # of k · cutoff: the bottom of the chart stands for none

# Of time against error: label, which of its points it stands at and whether right of it, colour, methods that a line
# joins, quantity of their time.
FAMILIES = [
    ("certified", 0, False, "blue", ["scene_certified"], "time"),
    ("global", 0, True, "green", ["scene_global"], "time"),
    ("descent", 0, True, "violet", [f"scene_descent_{n}" for n in (2, 10, 50, 200)], "servo_time"),
    ("decimated", -1, False, "orange", [f"decimated_{n}" for n in (4, 16, 64)], "time"),
    ("point shell", 0, False, "grey", ["point_shell"], "time"),
    ("FCL", 0, True, "red", ["fcl_rss"], "time"),
    ("Bullet", 0, False, "red", ["bullet_gimpact"], "time"),
]
GROWTH = [("search", "green"), ("kinetic_front", "blue"), ("descent_polar", "violet"), ("fcl_rss", "red")]


def chosen_scenes(results):
    """The real models where there are any."""
    scenes = results.scenes()
    return [scene for scene in scenes if scene.startswith("data:")] or scenes


def draw_family(results, chart, scene, family):
    label, labelled, right, colour, methods, quantity = family
    points = []
    for method in methods:
        time = results.pair(scene, method, quantity, "p50")
        error = results.pair(scene, method, "force_error", "rms")
        if time is not None and error is not None:
            points.append((time, max(error, NO_ERROR)))
    if not points:
        return
    chart.line(points, COLOURS[colour])
    chart.dots(points, COLOURS[colour])
    chart.label(points[labelled], label, COLOURS[colour], right)


def time_against_error(results, path):
    scenes = chosen_scenes(results)
    rows = (len(scenes) + 1) // 2
    drawing = Drawing(1000, 70 + 330 * rows, "Median time of an update against the force's error")
    for i, scene in enumerate(scenes):
        place = (70 + 490 * (i % 2), 70 + 330 * (i // 2), 400, 230)
        chart = Chart(drawing, place, (1, 1e5), (NO_ERROR, 10), scene.removeprefix("data:"), "µs (of the servo)",
                      "RMS error / (k · cutoff)")
        for family in FAMILIES:
            draw_family(results, chart, scene, family)
    drawing.text(500, drawing.height - 10, "descent: beside it a search every 2 (labelled), 10, 50, 200 ticks · "
                 "decimated to 1/4, 1/16, 1/64 (labelled) · FCL, Bullet: one contact · the bottom line: at most "
                 f"{NO_ERROR:g}", "middle")
    drawing.write(path)


def growth(results, path):
    scenes = results.scenes("growth")
    drawing = Drawing(90 + 460 * len(scenes), 440, "Time of a tick against the number of triangles of one shape")
    most = max(results.against("growth", "triangles", GROWTH[0][0], "time", "p50"))[0]
    for i, scene in enumerate(scenes):
        chart = Chart(drawing, (70 + 460 * i, 70, 380, 300), (9e3, 8 * most), (0.5, 1e4), scene, "triangles",
                      "µs (line: median, dashes: p99)")
        for method, colour in GROWTH:
            median, p99 = (results.against("growth", "triangles", method, "time", column, scene=scene)
                           for column in ("p50", "p99"))
            chart.line(median, COLOURS[colour])
            chart.dots(median, COLOURS[colour])
            chart.line(p99, COLOURS[colour], dash="4 3")
            chart.label(median[-1], method, COLOURS[colour])
    drawing.write(path)


def ratio_to_fcl(results, path):
    scenes, step = results.scenes(), 56
    left, top, height = 220, 70, step * len(results.scenes())
    drawing = Drawing(900, top + height + 50, "FCL's single minimum takes so many times longer than our complete set")
    chart = Chart(drawing, (left, top, 620, height), (0.1, 100), None, "", "times longer, at the median", "")
    for bar, colour in ((8, "blue"), (2, "green")):
        drawing.line([(chart.x(bar), top), (chart.x(bar), top + height)], COLOURS[colour], dash="4 3")
        drawing.text(chart.x(bar), top - 4, f"aim {bar}", "middle", colour=COLOURS[colour])
    for i, scene in enumerate(scenes):
        drawing.text(left - 10, top + step * i + 32, scene, "end")
        for k, (method, colour) in enumerate((("scene_certified", "blue"), ("scene_global", "green"))):
            ratio = results.pair(scene, "fcl_best", "time", "p50") / results.pair(scene, method, "time", "p50")
            y = top + step * i + 8 + 20 * k
            ends = sorted((chart.x(ratio), chart.x(1)))
            drawing.box(ends[0], y, ends[1] - ends[0], 16, COLOURS[colour])
            drawing.text(ends[1] + 6, y + 12, f"{ratio:.1f} {method.removeprefix('scene_')}")
    drawing.write(path)


def main():
    results, folder = Results(sys.argv[1]), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    if results.scenes():
        time_against_error(results, folder / "time_against_error.svg")
        ratio_to_fcl(results, folder / "ratio_to_fcl.svg")
    if results.find(bench="growth"):
        growth(results, folder / "growth.svg")


if __name__ == "__main__":
    main()
