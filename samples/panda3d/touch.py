"""touch.py MODELS: a hand leads a gear along a crankshaft in Panda3D. A spring ties the gear to the hand; where the gear
comes near the crankshaft, the forces of Palpate hold it off, so that it slides over the webs instead of going through.

MODELS is the folder of crankshaft_45k.glb and gear_6k.glb. Needs panda3d, panda3d-gltf, numpy and palpate."""

import argparse
import math
import sys
from pathlib import Path

import gltf
from direct.showbase.ShowBase import ShowBase
from panda3d.core import AmbientLight, DirectionalLight, Vec3, load_prc_file_data

import palpate
from panda_space import SPACE, model_of, pose_of

CUTOFF = 0.004  # m
STIFFNESS = 2000.0  # N/m of a contact
HAND = 60.0  # N/m between hand and gear
DRAG = 15.0  # N·s/m: how slowly the gear gives way
STEPS = 16  # of Palpate in a frame
FRAME = 1 / 60  # s
REACH = 0.12  # m, of the hand to both sides
HEIGHT = 0.085  # m: so low that the gear would go through the crankshaft


class Touch(ShowBase):
    def __init__(self, given):
        super().__init__(windowType="none" if given.headless else "onscreen")
        self.given, self.frame, self.seconds = given, 0, 0.0
        self.crankshaft = self.load(given.models / "crankshaft_45k.glb")
        self.gear = self.load(given.models / "gear_6k.glb")
        self.scene = palpate.Scene(CUTOFF, STIFFNESS, SPACE)
        self.scene.add(model_of(self.crankshaft))
        self.gear.set_pos(-REACH, 0, 0.13)
        self.tool = self.scene.add(model_of(self.gear), kind="tool")
        self.force = Vec3(0)
        if not given.headless:
            self.stage()
        self.task_mgr.add(self.touch, "touch")

    def load(self, path):
        node_path = self.render.attach_new_node(gltf.load_model(str(path)))
        node_path.flatten_light()
        return node_path

    def stage(self):
        self.set_background_color(0.93, 0.94, 0.96)
        self.disable_mouse()
        self.camera.set_pos(0, -0.6, 0.2)
        self.camera.look_at(0, 0, 0.05)
        self.camLens.set_near(0.01)
        for light, brightness in ((AmbientLight("all"), 0.4), (DirectionalLight("sun"), 0.6)):
            light.set_color((brightness, brightness, brightness, 1))
            placed = self.render.attach_new_node(light)
            placed.set_hpr(-30, -50, 0)
            self.render.set_light(placed)

    def touch(self, task):
        for _ in range(STEPS):
            self.step(FRAME / STEPS)
        self.frame += 1
        if self.given.frames:
            x, _, z = self.gear.get_pos()
            contacts = self.scene.contacts()
            print(f"frame {self.frame}: x {x:.4f} z {z:.4f}, {contacts.set_count} contacts, "
                  f"force {self.force.x:.3f} {self.force.y:.3f} {self.force.z:.3f}, overlap {contacts.overlap}")
            if self.frame == self.given.frames:
                self.task_mgr.stop()
        return task.cont

    def step(self, seconds):
        """A massless gear in a viscous hand: its speed is what spring and contacts push with, over the drag."""
        self.seconds += seconds
        hand = Vec3(-REACH * math.cos(self.seconds), 0, HEIGHT)
        at = self.gear.get_pos()
        self.gear.set_pos(at + ((hand - at) * HAND + self.force) * (seconds / DRAG))
        self.tool.pose = pose_of(self.gear, self.render)
        self.force = Vec3(*self.scene.step().wrench.force)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", type=Path)
    parser.add_argument("--headless", action="store_true", help="without a window")
    parser.add_argument("--frames", type=int, default=0, help="end after so many, each told on a line of its own")
    load_prc_file_data("", "audio-library-name null\nwindow-title Palpate")
    Touch(parser.parse_args()).task_mgr.run()


if __name__ == "__main__":
    sys.exit(main())
