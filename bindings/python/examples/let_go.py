"""Lets one model fall onto another: SciPy integrates its motion, Palpate gives the force of all contacts.

    python let_go.py crankshaft_45k.glb gear_6k.glb"""

import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import palpate

MASS, DAMPING = 0.2, 5.0  # kg, N·s/m
GRAVITY = np.array([0.0, -9.81, 0.0])

scene = palpate.Scene(cutoff=0.003, stiffness=1000)
scene.add(palpate.Model.load(sys.argv[1]))
tool = scene.add(palpate.Model.load(sys.argv[2]), kind="tool")
quaternion = Rotation.from_euler("x", -60, degrees=True).as_quat()


def motion(_, state):
    position, velocity = np.split(state, 2)
    tool.pose = (*position, *quaternion)
    force = np.array(scene.step().wrench.force)
    return np.concatenate([velocity, GRAVITY + (force - DAMPING * velocity) / MASS])


fall = solve_ivp(motion, (0, 0.4), [-0.005, 0.075, -0.02, 0, 0, 0], max_step=0.002)
motion(0, fall.y[:, -1])
contacts = scene.contacts()
x, y, z = 1000 * fall.y[:3, -1]
print(f"after {fall.t[-1]:.1f} s it has slid to {x:.1f} {y:.1f} {z:.1f} mm, "
      f"{1000 * contacts.min_distance:.2f} mm from the nearest of {contacts.set_count} contacts")
