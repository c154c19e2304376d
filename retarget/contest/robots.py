"""Robots for MuJoCo: URDF files of this repository and of a package of PyPI, with a floating base and sites at goals."""

import dataclasses
import pathlib
import re
import xml.etree.ElementTree as xml

import mujoco
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
# Shapes of collision for the repository's humanoid, which has none: link, origin, shape.
SHAPES = [
    ("pelvis", "0 0 0", "<box size='0.14 0.16 0.12'/>"),
    ("chest", "0 0 0.12", "<box size='0.14 0.16 0.24'/>"),
] + [
    (f"{side}_{link}", origin, shape)
    for side in ("left", "right")
    for link, origin, shape in (
        ("foot", "0.03 0 -0.02", "<box size='0.2 0.08 0.02'/>"),
        ("thigh", "0 0 -0.1", "<cylinder length='0.22' radius='0.05'/>"),
        ("shin", "0 0 -0.15", "<cylinder length='0.22' radius='0.04'/>"),
        ("hand", "0.05 0 0", "<sphere radius='0.04'/>"),
    )
]
PINOCCHIO = {
    "g1": "g1_description/urdf/g1_29dof_rev_1_0.urdf",
    "talos": "talos_data/robots/talos_full_v2.urdf",
    "romeo": "romeo_description/urdf/romeo.urdf",
    "icub": "icub_description/robots/icub.urdf",
}


@dataclasses.dataclass
class Robot:
    name: str
    urdf: pathlib.Path  # as dq8 reads it
    spec: mujoco.MjSpec  # as MuJoCo measures it


def all_of_them(folder):
    """Returns the robots; their files go to `folder`."""
    root = xml.parse(HERE.parent.parent / "robot/robots/humanoid.urdf").getroot()
    for link, origin, shape in SHAPES:
        node = next(node for node in root.iter("link") if node.get("name") == link)
        node.append(xml.fromstring(f"<collision><origin xyz='{origin}'/><geometry>{shape}</geometry></collision>"))
    yield robot("humanoid", root, folder, None)
    try:
        from importlib.metadata import files

        share = next(path for path in files("example-robot-data") if path.name == "g1_29dof_rev_1_0.urdf")
    except Exception:
        return
    share = pathlib.Path(share.locate()).resolve().parents[2]
    for name, path in PINOCCHIO.items():
        yield robot(name, xml.parse(share / path).getroot(), folder, share)
        if name == "g1":
            yield fitted(name, xml.parse(share / path).getroot(), folder, share)


def robot(name, root, folder, share):
    urdf = folder / f"{name}.urdf"
    urdf.write_bytes(xml.tostring(root))
    return Robot(name, urdf, spec_of(root, share))


def spec_of(root, share):
    """Returns the model of MuJoCo: no visuals, no meshes that it does not read, a base that floats."""
    for link in root.iter("link"):
        for node in [node for node in link if node.tag in ("visual", "inertial")]:
            link.remove(node)
        for node in [node for node in link if node.tag == "collision"]:
            mesh = node.find("geometry/mesh")
            if mesh is None:
                continue
            path = share / re.sub(r"^package:///?(example-robot-data/robots/)?", "", mesh.get("filename"))
            mesh.set("filename", str(path))
            if path.suffix.lower() not in (".stl", ".obj") or not path.exists():
                link.remove(node)
    for node in [node for node in root if node.tag not in ("link", "joint")]:
        root.remove(node)
    root.append(xml.fromstring(
        "<mujoco><compiler fusestatic='false' strippath='false' boundmass='1' boundinertia='1'/></mujoco>"
    ))
    spec = mujoco.MjSpec.from_string(xml.tostring(root, encoding="unicode"))
    base = spec.worldbody.first_body()
    if not base.joints:
        base.add_freejoint()
    for geom in spec.geoms:
        geom.contype = geom.conaffinity = 1
    return spec


def fitted(name, root, folder, share):
    """Returns the robot with a cylinder in place of each mesh of collision, of the size that MuJoCo fits, for both."""
    shaped = xml.fromstring(xml.tostring(root))
    spec = spec_of(root, share)
    meshes = [geom.type == mujoco.mjtGeom.mjGEOM_MESH for geom in spec.geoms]
    for geom, is_mesh in zip(spec.geoms, meshes):
        if is_mesh:
            geom.type = mujoco.mjtGeom.mjGEOM_CYLINDER
    model = spec.copy().compile()
    for link in shaped.iter("link"):
        for node in [node for node in link if node.tag == "collision" and node.find("geometry/mesh") is not None]:
            link.remove(node)
        body = model.body(link.get("name")).id
        for geom in np.flatnonzero((model.geom_bodyid == body) & meshes):
            (radius, half, _), (x, y, z) = model.geom_size[geom], model.geom_pos[geom]
            w, a, b, c = model.geom_quat[geom]
            roll = np.arctan2(2 * (w * a + b * c), 1 - 2 * (a * a + b * b))
            pitch = np.arcsin(np.clip(2 * (w * b - c * a), -1, 1))
            yaw = np.arctan2(2 * (w * c + a * b), 1 - 2 * (b * b + c * c))
            link.append(xml.fromstring(
                f"<collision><origin xyz='{x} {y} {z}' rpy='{roll} {pitch} {yaw}'/>"
                f"<geometry><cylinder radius='{radius}' length='{2 * half}'/></geometry></collision>"
            ))
    urdf = folder / f"{name}_fitted.urdf"
    urdf.write_bytes(xml.tostring(shaped))
    return Robot(f"{name}, cylinders", urdf, spec)
