# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: 2026 The mason-physics authors
"""Chains of pinned rods in MuJoCo and Chipmunk (pymunk), for the report: prints engine, method, step, cost, error, energy, gap.

    rods.py RODS SECONDS TIP_X TIP_Y STEP...
"""
import math
import sys
import time

G = 9.81


def median_cost(run, seconds):
    """Median CPU time per simulated second of runs for about half a second."""
    costs = []
    begun = time.process_time()
    while len(costs) < 3 or time.process_time() - begun < 0.5:
        before = time.process_time()
        result = run()
        costs.append((time.process_time() - before) / seconds)
        if costs[-1] * seconds > 5:
            break
    return sorted(costs)[len(costs) // 2], result


def mujoco_chain(mujoco, rods, integrator):
    inner = ""
    for k in reversed(range(rods)):
        inner = (
            f'<body pos="{0 if k == 0 else 1} 0 0"><joint type="hinge" axis="0 1 0" damping="0"/>'
            f'<inertial pos="0.5 0 0" mass="1" diaginertia="{1 / 12} {1 / 12} {1 / 12}"/>{inner}</body>'
        )
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><option gravity="0 0 {-G}" integrator="{integrator}"><flag contact="disable"/></option>'
        f'<worldbody>{inner}</worldbody></mujoco>'
    )


def run_mujoco(rods, seconds, tip, steps):
    try:
        import mujoco
    except ImportError:
        return
    for method in ("RK4", "implicit"):
        model = mujoco_chain(mujoco, rods, method)
        for step in steps:
            model.opt.timestep = step

            def run():
                data = mujoco.MjData(model)
                mujoco.mj_step(model, data, nstep=round(seconds / step))
                return data

            cost, data = median_cost(run, seconds)
            angle = x = z = 0.0
            for k in range(rods):
                angle += data.qpos[k]
                x += math.cos(angle)
                z -= math.sin(angle)
            error = math.hypot(x - tip[0], z - tip[1])
            print(f"MuJoCo,{method},{step!r},{cost!r},{error!r},NaN,0.0")


def run_chipmunk(rods, seconds, tip, steps):
    try:
        import pymunk
    except ImportError:
        return
    for iterations in (10, 50):
        for step in steps:

            def run():
                space = pymunk.Space()
                space.iterations = iterations
                space.gravity = (0, -G)
                last = space.static_body
                for k in range(rods):
                    rod = pymunk.Body(1, 1 / 12)
                    rod.position = (k + 0.5, 0)
                    joint = pymunk.PivotJoint(last, rod, (k, 0))
                    joint.error_bias = 0
                    space.add(rod, joint)
                    last = rod
                for _ in range(round(seconds / step)):
                    space.step(step)
                return last

            cost, last = median_cost(run, seconds)
            end = last.local_to_world((0.5, 0))
            error = math.hypot(end.x - tip[0], end.y - tip[1])
            print(f"Chipmunk,{iterations} iterations,{step!r},{cost!r},{error!r},NaN,NaN")


def main():
    rods, seconds = int(sys.argv[1]), float(sys.argv[2])
    tip = float(sys.argv[3]), float(sys.argv[4])
    steps = [float(s) for s in sys.argv[5:]]
    run_mujoco(rods, seconds, tip, steps)
    run_chipmunk(rods, seconds, tip, steps)


main()
