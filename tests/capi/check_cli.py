"""Runs the command-line tool as a script would: its outputs, and one line and exit code 1 for every mistake."""

import base64
import csv
import json
import os
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOL = sys.argv.pop()


def box_gltf(half):
    """A closed box about the origin."""
    corners = [(x, y, z) for z in (-half, half) for y in (-half, half) for x in (-half, half)]
    triangles = (0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5)
    data = b"".join(struct.pack("<3f", *corner) for corner in corners) + struct.pack("<36H", *triangles)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [-half] * 3, "max": [half] * 3},
            {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
        "buffers": [{"byteLength": len(data), "uri": uri}]})


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="palpate-cli-")
        self.addCleanup(self.folder.cleanup)
        self.box = self.write("box.gltf", box_gltf(0.5))

    def write(self, name, text):
        path = Path(self.folder.name) / name
        path.write_text(text)
        return str(path)

    def run_tool(self, *arguments):
        return subprocess.run([TOOL, *arguments], capture_output=True, text=True, timeout=60)

    def output(self, *arguments):
        done = self.run_tool(*arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def complaint(self, *arguments):
        done = self.run_tool(*arguments)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        return done.stderr

    def query(self, *pose):
        return json.loads(self.output("query", self.box, self.box, "--pose", *pose, "--cutoff", "0.2", "--json"))

    def test_query_with_negative_numbers(self):
        found = self.query("-1.125", "-0", "-1e-9", "0", "0", "-0", "-1")
        self.assertEqual({lmd["set"] for lmd in found["lmds"]}, {0})
        self.assertAlmostEqual(sum(lmd["weight"] for lmd in found["lmds"]), 1.0)
        for lmd in found["lmds"]:
            self.assertEqual(lmd["distance"], 0.125)
            self.assertEqual((lmd["a"][0], lmd["b"][0]), (-0.5, -0.625))
        self.assertFalse(found["overlap"])
        self.assertAlmostEqual(found["wrench"]["force"][0], -75.0)
        self.assertGreater(found["search_us"], 0.0)

    def test_query_names_features(self):
        lmd, = self.query("1.0625", "1.0625", "1.0625", "0", "0", "0", "1")["lmds"]
        self.assertEqual((lmd["feature_a"], lmd["feature_b"]), ("vertex", "vertex"))

    def test_query_reports_overlap(self):
        self.assertTrue(self.query("0.5", "0.25", "0.125", "0", "0", "0", "1")["overlap"])

    def test_query_table(self):
        text = self.output("query", self.box, self.box, "--pose", "1.1", "0", "0", "0", "0", "0", "1", "--cutoff", "0.2")
        self.assertIn("1 local minimum distances", text)

    def test_info(self):
        info = json.loads(self.output("info", self.box, "--json"))
        self.assertEqual((info["triangles"], info["welded_vertices"], info["stored_vertices"]), (12, 8, 8))
        self.assertEqual((info["watertight"], info["orientation"]), (True, "outward"))
        self.assertEqual(info["searched"]["triangles"], 12)
        self.assertEqual(info["bounds"], {"min": [-0.5] * 3, "max": [0.5] * 3})
        self.assertGreater(info["tree_nodes"], 0)
        self.assertEqual((info["read_bytes"], info["decoded_bytes"]), (len(box_gltf(0.5)), 96 + 72))
        self.assertIn("168 bytes decoded", self.output("info", self.box))
        self.assertIn("outward", self.output("info", self.box))

    def test_scene(self):
        nodes = [{"name": "table", "mesh": 0, "scale": [4, 0.2, 4], "children": [1]},
                 {"name": "cup", "mesh": 0, "translation": [0, 3, 0],
                  "extras": {"stiffness": 200, "friction": 0}},
                 {"name": "pen\u001b", "mesh": 0, "translation": [0, 2, 0]}]
        document = json.loads(box_gltf(0.5)) | {"nodes": nodes, "scenes": [{"nodes": [0, 2]}]}
        path = self.write("scene.gltf", json.dumps(document))
        table, cup, pen = json.loads(self.output("scene", path, "--tool", "pen\u001b", "--json"))["bodies"]
        self.assertEqual((table["name"], table["kind"], table["triangles"]), ("table", "static", 12))
        self.assertEqual((table["stiffness"], table["friction"], table["above_node"]), (None, None, None))
        self.assertEqual((cup["stiffness"], cup["damping"], cup["friction"]), (200.0, None, 0.0))
        self.assertEqual((cup["node"], cup["above_node"], cup["intangible"]), (1, 0, False))
        self.assertAlmostEqual(cup["position"][1], 0.6, delta=1e-12)
        self.assertEqual(pen["kind"], "tool")
        lines = self.output("scene", path).splitlines()
        self.assertEqual(len(lines), 4)
        self.assertRegex(lines[2], r"^cup +static +12 +0 0.6 0 +0 0 0 1 +200 +- +0$")
        self.assertIn("pen?", lines[3])
        self.assertIn("nobody", self.complaint("scene", path, "--tool", "nobody"))

    def test_scale(self):
        tripled = json.loads(self.output("info", self.box, "--scale", "3", "--json"))
        self.assertEqual(tripled["bounds"], {"min": [-1.5] * 3, "max": [1.5] * 3})
        pose = ("--pose", "2.125", "0", "0", "0", "0", "0", "1", "--cutoff", "0.2")
        found = json.loads(self.output("query", self.box, self.box, *pose, "--scale-a", "3", "--json"))
        self.assertEqual({(lmd["a"][0], lmd["b"][0], lmd["distance"]) for lmd in found["lmds"]}, {(1.5, 1.625, 0.125)})
        poses = self.write("still.csv", "t,px,py,pz,qx,qy,qz,qw\n0,2.125,0,0,0,0,0,1\n")
        out = str(Path(self.folder.name) / "scaled.csv")
        self.output("run", self.box, self.box, "--trajectory", poses, "--cutoff", "0.2", "--scale-b", "3", "--out", out)
        with open(out, newline="") as file:
            self.assertEqual([float(tick["min_distance"]) for tick in csv.DictReader(file)], [0.125])
        self.assertIn("--scale-b", self.complaint("query", self.box, self.box, *pose, "--scale-b", "0"))

    def test_run(self):
        rows = ["t,px,py,pz,qx,qy,qz,qw", "0,1.125,0,0,0,0,0,1", "0.001,1.125,0,0,0,0,0,1\r", "0.002,-9,0,0,0,0,0,1", ""]
        poses = self.write("poses.csv", "\n".join(rows))
        out = str(Path(self.folder.name) / "ticks.csv")
        summary = json.loads(self.output("run", self.box, self.box, "--trajectory", poses, "--cutoff", "0.2", "--law", "springs",
                                         "--stiffness", "500", "--mode", "global", "--out", out, "--json"))
        self.assertEqual((summary["ticks"], summary["ticks_in_contact"]), (3, 2))
        with open(out, newline="") as file:
            ticks = list(csv.DictReader(file))
        self.assertEqual(",".join(ticks[0]), "t,lmds,min_distance,fx,fy,fz,tx,ty,tz,local_us,global_us,pairs,age_ticks")
        self.assertEqual([tick["lmds"] for tick in ticks], ["1", "1", "0"])
        self.assertEqual([float(tick["t"]) for tick in ticks], [0.0, 0.001, 0.002])
        self.assertAlmostEqual(float(ticks[0]["fx"]), 37.5)
        self.assertGreater(float(ticks[0]["global_us"]), 0.0)
        self.assertEqual(float(ticks[1]["global_us"]), 0.0, "nothing moved, so nothing is searched")
        self.assertEqual(float(ticks[2]["min_distance"]), float("inf"))

    def test_run_with_damping_friction_and_cap(self):
        poses = self.write("press.csv", "t,px,py,pz,qx,qy,qz,qw\n0,1.102,-0.002,0,0,0,0,1\n0.001,1.1,0,0,0,0,0,1\n"
                                        "0.002,0.99,0,0,0,0,0,1\n")
        out = str(Path(self.folder.name) / "pressed.csv")
        summary = json.loads(self.output("run", self.box, self.box, "--trajectory", poses, "--cutoff", "0.2", "--law", "springs",
                                         "--damping", "30", "--friction", "0.1", "--stiffness-cap", "400",
                                         "--out", out, "--json"))
        self.assertEqual(summary["ticks_overlapping"], 1)
        with open(out, newline="") as file:
            pressed = list(csv.DictReader(file))[1]
        yielding = 1 + 2 * 1000 / 400
        self.assertAlmostEqual(float(pressed["fx"]), (100 + 60) / yielding, delta=1e-6)
        self.assertAlmostEqual(float(pressed["fy"]), -16 / yielding, delta=1e-6)
        self.assertIn("--friction", self.complaint("run", self.box, self.box, "--trajectory", poses, "--cutoff", "0.2", "--law", "springs",
                                                   "--friction", "-1"))

    def test_devices(self):
        devices = {device["uri"]: device for device in json.loads(self.output("devices", "--json"))}
        self.assertEqual(devices["sim:touch"]["max_torque"], 0)
        self.assertGreater(devices["sim:premium6dof"]["max_torque"], 0)
        self.assertIn("sim:premium6dof", self.output("devices"))
        os.environ["PALPATE_OPENHAPTICS_LIBRARY"] = "/nonexistent/libHD.so"
        self.addCleanup(os.environ.pop, "PALPATE_OPENHAPTICS_LIBRARY")
        self.assertIn("libHD.so not found: install OpenHaptics 3.4", self.output("devices"))

    def test_run_by_the_smooth_law(self):
        rows = ["t,px,py,pz,qx,qy,qz,qw"] + [f"{0.001 * i},1.1,0,0,0,0,{0.0004 * (i - 50)},1" for i in range(100)]
        poses = self.write("rock.csv", "\n".join(rows))
        steps = {}
        for law in ("springs", "smooth"):
            out = str(Path(self.folder.name) / f"{law}.csv")
            self.output("run", self.box, self.box, "--trajectory", poses, "--cutoff", "0.2", "--stiffness", "500",
                        "--law", law, "--out", out)
            with open(out, newline="") as file:
                torques = [float(tick["tz"]) for tick in csv.DictReader(file)]
            steps[law] = max(abs(b - a) for a, b in zip(torques, torques[1:]))
        self.assertLess(steps["smooth"], 0.2 * steps["springs"], "a box that rocks changes its corner without a jump")

    def test_run_in_every_mode(self):
        rows = ["t,px,py,pz,qx,qy,qz,qw"] + [f"{0.001 * i},{1.15 - 0.001 * i},0.01,0,0,0,{0.001 * i},1" for i in range(40)]
        poses = self.write("motion.csv", "\n".join(rows))
        forces = {}
        for mode in ("global", "descent", "certified"):
            out = str(Path(self.folder.name) / f"{mode}.csv")
            self.output("run", self.box, self.box, "--trajectory", poses, "--cutoff", "0.2", "--law", "springs", "--stiffness", "500",
                        "--mode", mode, "--global-every", "7", "--out", out)
            with open(out, newline="") as file:
                ticks = list(csv.DictReader(file))
            forces[mode] = [(tick["lmds"], tick["fx"], tick["fy"], tick["tz"]) for tick in ticks]
            searched = [i for i, tick in enumerate(ticks) if float(tick["global_us"]) > 0]
            self.assertEqual(searched, {"global": list(range(40)), "descent": list(range(0, 40, 7)), "certified": []}[mode])
            self.assertEqual({int(tick["age_ticks"]) for tick in ticks}, set(range(7)) if mode == "descent" else {0})
        self.assertEqual(forces["certified"], forces["global"])
        for mode in ("descent", "certified"):
            run = json.loads(self.output("run", self.box, self.box, "--trajectory", poses, "--cutoff", "0.2",
                                         "--mode", mode, "--compare", "--json"))
            compared = run["comparison"]
            self.assertGreater(compared["sets"], 10)
            for quantity in ("node_pairs", "triangle_pairs", "descent_steps", "front_expired", "age_ticks"):
                p50, p99, most = (run[f"work_{statistic}"][quantity] for statistic in ("p50", "p99", "max"))
                self.assertTrue(0 <= p50 <= p99 <= most and run["work"][quantity] <= most, quantity)
            self.assertEqual(run["work_max"]["age_ticks"], 9 if mode == "descent" else 0)
            self.assertEqual(compared["spurious"], 0)
            if mode == "certified":
                self.assertEqual((compared["missed"], compared["force_error_max"], compared["torque_error_max"]), (0, 0, 0))
        self.assertIn("--threaded", self.complaint("run", self.box, self.box, "--trajectory", poses, "--cutoff", "0.2",
                                                   "--compare", "--threaded"))
        for one, other in zip(forces["descent"], forces["global"]):
            self.assertEqual(one[0], other[0])
            self.assertAlmostEqual(float(one[1]), float(other[1]), delta=1e-6)

    def test_run_threaded(self):
        rows = ["t,px,py,pz,qx,qy,qz,qw"] + [f"{0.005 * i},{1.15 - 0.0005 * i},0.01,0,0,0,0,1" for i in range(60)]
        poses = self.write("slow.csv", "\n".join(rows))
        for mode in ("global", "descent", "certified"):
            out = str(Path(self.folder.name) / f"threaded_{mode}.csv")
            summary = json.loads(self.output("run", self.box, self.box, "--trajectory", poses, "--cutoff", "0.2", "--law", "springs", "--mode",
                                             mode, "--threaded", "--out", out, "--json"))
            with open(out, newline="") as file:
                ticks = list(csv.DictReader(file))
            self.assertEqual([float(tick["t"]) for tick in ticks], [0.005 * i for i in range(60)])
            self.assertGreater(summary["servo"]["ticks"], 0)
            self.assertGreater(summary["servo"]["work_us"]["max"], 0)
            self.assertGreater(summary["ticks_in_contact"], 0)
            felt = [float(tick["min_distance"]) for tick in ticks if tick["lmds"] == "1"]
            self.assertTrue(set(round((distance - 0.15) / 0.0005, 6) for distance in felt) <= set(range(-59, 1)), felt)
            self.assertEqual(felt, sorted(felt, reverse=True), "no outcome comes before an older one")

    def test_record_and_replay(self):
        rows = ["t,px,py,pz,qx,qy,qz,qw"] + [f"{0.001 * i},{1.15 - 0.001 * i},0.01,{0.002 * i},0.1,0,{0.001 * i},1" for i in range(60)]
        poses = self.write("motion.csv", "\n".join(rows))

        def run(trajectory, name, *options):
            trace, out = (str(Path(self.folder.name) / (name + suffix)) for suffix in (".trace", ".csv"))
            summary = json.loads(self.output("run", self.box, self.box, "--trajectory", trajectory, *options, "--record",
                                             trace, "--out", out, "--json"))
            self.assertEqual((summary["recording"]["ticks"], summary["recording"]["lost"]), (60, 0))
            self.assertEqual(summary["recording"]["bytes"], Path(trace).stat().st_size)
            with open(out, newline="") as file:
                ticks = list(csv.DictReader(file))
            same = ("lmds", "min_distance", "fx", "fy", "fz", "tx", "ty", "tz", "pairs", "age_ticks")
            return trace, [tuple(tick[name] for name in same) for tick in ticks]

        for mode in ("global", "descent", "certified"):
            for law in ("springs", "smooth"):
                asked = ("--cutoff", "0.2", "--mode", mode, "--law", law, "--stiffness", "321", "--damping", "2",
                         "--friction", "0.2", "--global-every", "6")
                trace, told = run(poses, f"{mode}_{law}", *asked)
                self.assertGreater(len({tick[2] for tick in told}), 20)
                again, replayed = run(trace, f"again_{mode}_{law}")
                self.assertEqual(replayed, told)
                self.assertEqual(run(again, f"third_{mode}_{law}")[1], told)
        stiffer = run(trace, "stiffer", "--stiffness", "642", "--damping", "0", "--friction", "0")[1]
        self.assertNotEqual(stiffer, told)
        self.assertEqual([tick[:2] for tick in stiffer], [tick[:2] for tick in told])
        compared = json.loads(self.output("run", self.box, self.box, "--trajectory", trace, "--compare", "--json"))
        self.assertEqual(compared["comparison"]["missed"], 0)
        damaged = Path(self.folder.name) / "damaged.trace"
        damaged.write_bytes(Path(trace).read_bytes()[:100])
        self.assertIn("damaged.trace", self.complaint("run", self.box, self.box, "--trajectory", str(damaged)))
        self.assertIn("--cutoff", self.complaint("run", self.box, self.box, "--trajectory", poses))
        self.assertIn("/nowhere", self.complaint("run", self.box, self.box, "--trajectory", trace, "--record", "/nowhere/x"))

    def test_mistakes(self):
        poses = self.write("poses.csv", "t,px,py,pz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,2,3\n")
        header = self.write("header.csv", "time,x\n")
        garbage = self.write("garbage.glb", "this is no glTF")
        run = ("run", self.box, self.box, "--cutoff", "1", "--trajectory")
        self.assertIn("missing.glb", self.complaint("info", "missing.glb"))
        self.assertIn("garbage.glb", self.complaint("info", garbage))
        self.assertIn("poses.csv:3", self.complaint(*run, poses))
        self.assertIn("header.csv:1", self.complaint(*run, header))
        self.assertIn("certified", self.complaint(*run, poses, "--mode", "telepathic"))
        backwards = self.write("backwards.csv", "t,px,py,pz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n0,0,0,0,0,0,0,1\n")
        self.assertIn("backwards.csv", self.complaint(*run, backwards, "--threaded"))
        self.assertIn("--global-every", self.complaint(*run, poses, "--global-every", "0"))
        self.assertIn("smooth", self.complaint(*run, poses, "--law", "telepathic"))
        self.assertIn("--pose", self.complaint("query", self.box, self.box, "--pose", "1", "2", "--cutoff", "1"))
        self.assertIn("--cutoff", self.complaint("query", self.box, self.box, "--pose", *"0000001", "--cutoff", "-1"))
        self.assertIn("--pose", self.complaint("query", self.box, self.box, "--pose", *"0000000", "--cutoff", "1"))
        self.assertIn("--stiffness", self.complaint("query", self.box, self.box, "--pose", *"0000001", "--cutoff", "1",
                                                    "--stiffness", "-1"))
        self.complaint()
        self.complaint("touch")

    def test_help_and_version(self):
        self.assertIn("query", self.output("--help"))
        self.assertIn("--pose", self.output("query", "--help"))
        self.assertRegex(self.output("--version"), r"^\d+\.\d+\.\d+\n$")


unittest.main()
