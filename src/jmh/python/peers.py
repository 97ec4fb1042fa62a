# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: 2026 The mason-physics authors
"""Runs scenes in MuJoCo and pymunk for the report of speed against error.

Says on the first line which engines there are. Then each line of input is a JSON object with engine, tuned, dt, steps (from
one instant to the next), samples, read, and the scene; each line of output holds the CPU seconds of the thread, and if
read is true all states.
"""
import json
import math
import sys
import time

try:
    import mujoco
except ImportError:
    mujoco = None
try:
    import pymunk
except ImportError:
    pymunk = None


def hinge(x, y):
    return f'<joint type="hinge" axis="0 0 1" pos="{x!r} {y!r} 0"/>'


class MujocoWorld:
    """Reduced coordinates; pins that close loops are equality constraints."""

    def __init__(self, scene, dt, tuned):
        parts = scene["parts"]
        pins = [list(p) for p in scene["pins"]] + [[a, -1, x, y] for a, x, y in scene["rods"]]
        children = {k: [] for k in range(-1, len(parts))}
        seen = {-1} | set(scene["slides"])
        loops = list(pins)
        grown = True
        while grown:
            grown = False
            for pin in list(loops):
                a, b, x, y = pin
                if (a in seen) != (b in seen):
                    parent, child = (a, b) if a in seen else (b, a)
                    children[parent].append((child, x, y))
                    seen.add(child)
                    loops.remove(pin)
                    grown = True
        self.slides = scene["slides"]
        fixed = [k for k in range(len(parts)) if parts[k]["fixed"]]
        self.loose = [k for k in range(len(parts)) if k not in seen and k not in fixed]
        self.order = []
        text = []
        # parts that meet are free bodies here: no scene has both joints and contacts for this engine
        touching = any(p["collides"] for p in parts)

        def grow(k, parent, joints):
            p = parts[k]
            px, py = (0.0, 0.0) if parent < 0 else parts[parent]["start"][:2]
            cx, cy = p["start"][:2]
            inertia = max(p["inertia"], 1e-14)
            turn = f'euler="0 0 {p["start"][2]!r}"' if touching else ""
            text.append(f'<body name="b{k}" pos="{cx - px!r} {cy - py!r} 0" {turn}>')
            if joints:
                text.append(f'<inertial pos="0 0 0" mass="{p["mass"]!r}" diaginertia="{inertia!r} {inertia!r} {inertia!r}"/>')
            text.append(joints)
            if touching and p["collides"]:
                text.append(self.geom(p, scene["friction"]))
            for n, s in enumerate(scene["springs"]):
                if int(s[0]) == k:
                    text.append(f'<site name="s{n}" pos="{s[1] - cx!r} {s[2] - cy!r} 0"/>')
            self.order.append((k, parent))
            for child, x, y in children[k]:
                c = parts[child]["start"]
                grow(child, k, hinge(x - c[0], y - c[1]))
            text.append("</body>")

        for child, x, y in children[-1]:
            c = parts[child]["start"]
            grow(child, -1, hinge(x - c[0], y - c[1]))
        for k in scene["slides"]:
            grow(k, -1, '<joint type="slide" axis="1 0 0"/>')
        for k in fixed:
            grow(k, -1, "")
        for k in self.loose:
            grow(k, -1, '<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/>' + hinge(0.0, 0.0))
        sites = "".join(f'<site name="w{n}" pos="{s[3]!r} {s[4]!r} 0"/>' for n, s in enumerate(scene["springs"]))
        tendons = "".join(
            f'<spatial stiffness="{s[6]!r}" damping="{s[7]!r}" springlength="{s[5]!r}"><site site="w{n}"/><site site="s{n}"/></spatial>'
            for n, s in enumerate(scene["springs"]))
        stiff = f'solref="{2 * dt!r} 1" solimp="0.9999 0.9999 0.001 0.5 2"' if tuned else ""
        equal = ""
        for a, b, x, y in loops:
            c = parts[a]["start"]
            other = "" if b < 0 else f'body2="b{b}"'
            equal += f'<connect body1="b{a}" {other} anchor="{x - c[0]!r} {y - c[1]!r} 0" {stiff}/>'
        integrator = "RK4" if tuned else "Euler"
        contacts = '<flag contact="disable"/>'
        cone = ""
        if touching:
            contacts = ""
            if tuned:
                cone = 'cone="elliptic" impratio="100"'
                contacts = f'<flag override="enable"/>'
                cone += f' o_solref="{2 * dt!r} 1" o_solimp="0.9999 0.9999 0.001 0.5 2" o_friction="{scene["friction"]!r} {scene["friction"]!r} 0 0 0"'
        xml = (f'<mujoco><compiler angle="radian" boundmass="0" boundinertia="0"/>'
               f'<option timestep="{dt!r}" gravity="{scene["across"]!r} {-scene["gravity"]!r} 0" integrator="{integrator}" tolerance="1e-15" {cone}>'
               f'{contacts}</option><worldbody>{sites}{"".join(text)}</worldbody>'
               f'<tendon>{tendons}</tendon><equality>{equal}</equality></mujoco>')
        self.model = mujoco.MjModel.from_xml_string(xml)
        self.data = mujoco.MjData(self.model)
        self.parts = parts
        self.ids = [mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_BODY, f"b{k}") for k in range(len(parts))]
        rates = []
        for k, parent in self.order:
            v = parts[k]["start"]
            if k in self.loose:
                rates += [v[3], v[4], v[5]]
            elif k in self.slides:
                rates.append(v[3])
            elif parts[k]["fixed"]:
                continue
            else:
                rates.append(v[5] - (0 if parent < 0 else parts[parent]["start"][5]))
        self.data.qvel[:] = rates
        self.offset = [0.0 if touching else p["start"][2] for p in parts]
        if scene["torque"]:
            self.data.xfrc_applied[self.ids[0], 5] = scene["torque"]
        if scene["push"]:
            self.data.xfrc_applied[self.ids[0], 0] = scene["push"]

    @staticmethod
    def geom(p, friction):
        rub = f'friction="{friction!r} 0 0" condim="{3 if friction else 1}"'
        if p["radius"]:
            return f'<geom type="sphere" size="{p["radius"]!r}" {rub}/>'
        x = max(c[0] for c in p["corners"])
        y = max(c[1] for c in p["corners"])
        return f'<geom type="box" size="{x!r} {y!r} 0.5" {rub}/>'

    def advance(self, steps):
        mujoco.mj_step(self.model, self.data, steps)

    def read(self):
        import numpy
        mujoco.mj_forward(self.model, self.data)
        state = []
        velocity = numpy.zeros(6)
        for k, body in enumerate(self.ids):
            q = self.data.xquat[body]
            mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_BODY, body, velocity, 0)
            angle = 2 * math.atan2(q[3], q[0]) + self.offset[k]
            state += [float(self.data.xipos[body][0]), float(self.data.xipos[body][1]), angle,
                      float(velocity[3]), float(velocity[4]), float(velocity[2])]
        return state


class PymunkWorld:
    """Chipmunk: with 10 iterations, or tuned with 50 and a small collision slop."""

    def __init__(self, scene, dt, tuned):
        self.dt = dt
        self.torque = scene["torque"]
        self.push = scene["push"]
        space = self.space = pymunk.Space()
        space.gravity = (scene["across"], -scene["gravity"])
        if tuned:
            space.iterations = 50
            space.collision_slop = 1e-6
        self.bodies = []
        for p in scene["parts"]:
            s = p["start"]
            if p["fixed"]:
                body = pymunk.Body(body_type=pymunk.Body.STATIC)
            else:
                body = pymunk.Body(p["mass"], max(p["inertia"], 1e-14))
            body.position = (s[0], s[1])
            body.angle = s[2]
            if not p["fixed"]:
                body.velocity = (s[3], s[4])
                body.angular_velocity = s[5]
            shape = pymunk.Circle(body, p["radius"]) if p["radius"] else pymunk.Poly(body, p["corners"])
            shape.elasticity = 1 if p["fixed"] else (p["e"] if len(scene["parts"]) > 0 else 1)
            # of two coefficients the product counts
            shape.friction = math.sqrt(scene["friction"])
            if not p["collides"]:
                shape.filter = pymunk.ShapeFilter(mask=0)
            space.add(body, shape)
            self.bodies.append(body)
        ground = space.static_body
        for a, b, x, y in scene["pins"]:
            space.add(pymunk.PivotJoint(self.bodies[a], ground if b < 0 else self.bodies[b], (x, y)))
        for a, x, y in scene["rods"]:
            space.add(pymunk.PinJoint(self.bodies[a], ground, (0, 0), (x, y)))
        for a in scene["slides"]:
            x, y = scene["parts"][a]["start"][:2]
            space.add(pymunk.GrooveJoint(ground, self.bodies[a], (x - 100, y), (x + 100, y), (0, 0)))
            space.add(pymunk.RotaryLimitJoint(ground, self.bodies[a], 0, 0))
        for a, px, py, x, y, length, stiffness, damping in scene["springs"]:
            body = self.bodies[int(a)]
            space.add(pymunk.DampedSpring(body, ground, body.world_to_local((px, py)), (x, y), length, stiffness, damping))

    def advance(self, steps):
        step = self.space.step
        dt = self.dt
        if self.torque or self.push:
            for _ in range(steps):
                self.bodies[0].torque = self.torque
                self.bodies[0].force = (self.push, 0)
                step(dt)
        else:
            for _ in range(steps):
                step(dt)

    def read(self):
        state = []
        for b in self.bodies:
            state += [b.position.x, b.position.y, b.angle, b.velocity.x, b.velocity.y, b.angular_velocity]
        return state


def main():
    if mujoco:
        # unstable settings show in the errors; no log file
        mujoco.set_mju_user_warning(lambda message: None)
    print(" ".join(n for n, m in (("mujoco", mujoco), ("pymunk", pymunk)) if m), flush=True)
    for line in sys.stdin:
        task = json.loads(line)
        try:
            make = MujocoWorld if task["engine"] == "mujoco" else PymunkWorld
            world = make(task["scene"], task["dt"], task["tuned"])
            numbers = []
            spent = 0.0
            for _ in range(task["samples"]):
                begun = time.thread_time()
                world.advance(task["steps"])
                spent += time.thread_time() - begun
                if task["read"]:
                    numbers += world.read()
            print(spent, *numbers, flush=True)
        except Exception as problem:
            print("error", str(problem).replace("\n", " "), flush=True)


main()
