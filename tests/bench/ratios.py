"""ratios.py CSV: prints what the run says about the bars that Palpate is measured by."""

import sys

from results import Results, parameter


def show(what, value, bar=None, unit=""):
    verdict = "" if bar is None else f"bar {bar:8.4g}  {'met' if value <= bar else 'MISSED'}"
    print(f"  {what:<58} {value:10.4g}{unit:<6} {verdict}")


def ratios_to_fcl(results):
    print("Palpate's time over that of FCL's single minimum (the better volume at each pose), cutoff 2 %")
    for scene in results.scenes():
        def ratio(method, column, scene=scene):
            return results.pair(scene, method, "time", column) / results.pair(scene, "fcl_best", "time", column)
        show(f"{scene}: certified, median", ratio("scene_certified", "p50"), 1 / 8)
        show(f"{scene}: certified, p99", ratio("scene_certified", "p99"), 1 / 3)
        show(f"{scene}: from scratch, median", ratio("scene_global", "p50"), 1 / 2)


def descents(results):
    print("Descent, microseconds an LMD and tick, median")
    for scene in results.scenes():
        for form, bar in (("polar", 0.5), ("neighbourhood", None)):
            show(f"{scene}: {form}", results.pair(scene, f"descent_{form}", "time_per_lmd", "p50"), bar, " us")


def completeness(results):
    print("LMDs that the certified set lacks or has too many, and its largest force error, over all ticks")
    for method in ("scene_certified", "kinetic_front"):
        for quantity, bar in (("lmds_missed", 0), ("lmds_spurious", 0), ("force_error", 1e-9)):
            rows = results.find(bench="pairs", method=method, quantity=quantity)
            show(f"{method}: {quantity}", max(float(row["max"]) for row in rows), bar)


def growth(results):
    print("Growth of the median tick from the fewest triangles to the most; the work at each")
    for scene in results.scenes("growth"):
        for method, bar in (("kinetic_front", 4.0), ("descent_polar", 1.3), ("search", None), ("fcl_rss", None)):
            def against(quantity, column, scene=scene, method=method):
                return results.against("growth", "triangles", method, quantity, column, scene=scene)
            values = against("time", "p50")
            show(f"{scene}: {method}, {values[0][0]:,.0f} to {values[-1][0]:,.0f}", values[-1][1] / values[0][1], bar)
            for quantity, column in (("lmds", "rms"), ("node_pairs", "p50"), ("triangle_pairs", "p50")):
                counts = against(quantity, column)
                if counts:
                    print(f"    {quantity} ({column}): {', '.join(f'{count:,.4g}' for _, count in counts)}")


def kernels(results):
    print("Kernels, nanoseconds a pair, median")
    for row in results.find(bench="kernels"):
        target = parameter(row, "target")
        bar = 25.0 if (row["method"], target) == ("triangle_batch", "AVX2") else None
        show(f"{row['method']}: {target}", float(row["p50"]), bar, " ns")


def build(results):
    largest = results.against("build", "triangles", "palpate", "time", "p50")
    nearest = min(largest, key=lambda entry: abs(entry[0] - 1e6))
    print(f"Build of {nearest[0]:,.0f} triangles")
    show("seconds for a million", nearest[1] * 1e-6 * 1e6 / nearest[0], 1.5, " s")
    show("bytes a triangle", results.against("build", "triangles", "palpate", "memory", "p50")[-1][1], 200, " B")


def bodies(results):
    print("Distant bodies add to a tick, median")
    for count, added in results.against("bodies", "distant", "scene_certified", "added", "p50"):
        show(f"{count:,.0f} bodies", added, 20.0, " us")


def main():
    results = Results(sys.argv[1])
    print(results.origin())
    present = {row["bench"] for row in results.rows}
    for bench, parts in (("pairs", (ratios_to_fcl, descents, completeness)), ("growth", (growth,)), ("kernels", (kernels,)), ("build", (build,)),
                         ("bodies", (bodies,))):
        if bench in present:
            for part in parts:
                part(results)


if __name__ == "__main__":
    main()
