"""figures.py CSV FOLDER: draws time against error, growth, and the ratios to FCL."""

import sys
from pathlib import Path

from results import Results
from svg import COLOURS, Chart, Drawing

NO_ERROR = 1e-4  # of k · cutoff: the bottom of the chart stands for none

# Of time against error: label, colour, methods that a line joins, quantity of their time.
FAMILIES = [
    ("certified", "blue", ["scene_certified"], "time"),
    ("global", "green", ["scene_global"], "time"),
    ("descent, a search every 2, 10, 50, 200 ticks", "violet", [f"scene_descent_{n}" for n in (2, 10, 50, 200)],
     "servo_time"),
    ("decimated to 1/4, 1/16, 1/64", "orange", [f"decimated_{n}" for n in (4, 16, 64)], "time"),
    ("point shell", "grey", ["point_shell"], "time"),
    ("FCL, one minimum", "red", ["fcl_rss"], "time"),
    ("Bullet, one contact", "red", ["bullet_gimpact"], "time"),
]
GROWTH = [("search", "green"), ("kinetic_front", "blue"), ("descent_polar", "violet"), ("fcl_rss", "red")]


def chosen_scenes(results):
    """The real models where there are any."""
    scenes = results.scenes()
    return [scene for scene in scenes if scene.startswith("data:")] or scenes


def draw_family(results, chart, scene, family):
    label, colour, methods, quantity = family
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
    chart.label(points[0], label.split(",")[0].split(" to ")[0], COLOURS[colour])


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
    drawing.text(500, drawing.height - 10, "descent: a search every 2, 10, 50, 200 ticks beside it · decimated to 1/4, "
                 f"1/16, 1/64 · the bottom line: at most {NO_ERROR:g}", "middle")
    drawing.write(path)


def growth(results, path):
    drawing = Drawing(640, 440, "Time of a tick against the number of triangles")
    chart = Chart(drawing, (70, 60, 520, 310), (1e4, 1e7), (1, 1e4), "one shape, the same motion and tool",
                  "triangles", "µs (line: median, dashes: p99)")
    for method, colour in GROWTH:
        median = results.against("growth", "triangles", method, "time", "p50")
        if not median:
            continue
        chart.line(median, COLOURS[colour])
        chart.dots(median, COLOURS[colour])
        chart.line(results.against("growth", "triangles", method, "time", "p99"), COLOURS[colour], dash="4 3")
        chart.label(median[-1], method, COLOURS[colour])
    drawing.write(path)


def ratio_to_fcl(results, path):
    scenes = results.scenes()
    drawing = Drawing(900, 100 + 56 * len(scenes), "FCL's single minimum takes so many times longer than the complete set")
    left, top, height = 220, 60, 56 * len(scenes)
    chart = Chart(drawing, (left, top, 620, height), (0.1, 1000), (1, 10), "", "times longer, at the median (log)", "")
    for i, scene in enumerate(scenes):
        drawing.text(left - 10, top + 56 * i + 32, scene, "end")
        for k, (method, colour) in enumerate((("scene_certified", "blue"), ("scene_global", "green"))):
            ratio = results.pair(scene, "fcl_best", "time", "p50") / results.pair(scene, method, "time", "p50")
            x = chart.x(ratio)
            drawing.box(min(x, chart.x(1)), top + 56 * i + 8 + 20 * k, abs(x - chart.x(1)), 16, COLOURS[colour])
            drawing.text(x + 6, top + 56 * i + 20 + 20 * k, f"{ratio:.1f} {method.removeprefix('scene_')}")
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
