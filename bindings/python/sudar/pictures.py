"""Pictures of a world, drawn as the program draws them, without a window; and what notebooks show of one."""

import base64
import html
import json
import struct
import zlib
from typing import Optional, Sequence, Tuple, Union

import numpy as np

from ._core import Session, World


def picture(world: World, size: Tuple[int, int] = (640, 360), camera: Optional[Sequence] = None, *, colour: str = "body",
            contacts: bool = False, joints: bool = False, forces: bool = False, axes: bool = False,
            wireframe: bool = False) -> np.ndarray:
    """The world as it is: (height, width, 4) bytes, red, green, blue, alpha, from the top.

    `size` is width and height; `camera` is (eye, target), points in m, or (eye, target, vertical field of view in rad), None:
    one that shows everything. `colour`: what colours tell, "body", "speed", "island" or "sleep". The rest are marks: contact
    points, joints, weights and the forces of contacts and joints, the bodies' axes; or edges only.
    """
    try:
        from . import _view  # type: ignore
    except ImportError as e:
        raise RuntimeError("this build of sudar draws no pictures: it was made without libepoxy, EGL or libpng") from e
    return _view.picture(world, size, camera, colour, contacts, joints, forces, axes, wireframe)


def png(pixels: np.ndarray) -> bytes:
    """The picture as a file: (height, width, 4) bytes."""
    pixels = np.ascontiguousarray(pixels, np.uint8)
    height, width, channels = pixels.shape
    if channels != 4:
        raise ValueError(f"pixels have shape {pixels.shape}, expected (height, width, 4)")

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = np.zeros((height, 1 + 4 * width), np.uint8)  # each row begins with its filter: none
    rows[:, 1:] = pixels.reshape(height, -1)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows.tobytes())) + chunk(b"IEND", b""))


def _html(world: World, title: str = "World") -> str:
    energy = world.energy
    rows = {"time": f"{world.time:.4g} s", "bodies": len(world.bodies), "joints": len(world.joints),
            "touching pairs": len(world.contacts), "kinetic energy": f"{energy.kinetic:.4g} J",
            "potential energy": f"{energy.potential:.4g} J"}
    cells = "".join(f"<tr><td>{name}</td><td>{value}</td></tr>" for name, value in rows.items())
    try:
        data = base64.b64encode(png(picture(world))).decode()
        image = f'<img alt="{html.escape(title)}" width="480" src="data:image/png;base64,{data}">'
    except RuntimeError:
        image = ""  # no OpenGL here: the numbers are still something
    return f"<div><b>{html.escape(title)}</b><br>{image}<table>{cells}</table></div>"


class Player:
    """A run as pictures, which a notebook plays: `sudar.Player(sudar.Session("dominoes"), seconds=3)`. Steps what it is given,
    a Session or a World, for so many simulated seconds."""

    def __init__(self, run: Union[Session, World], seconds: float, frames_per_second: float = 20,
                 size: Tuple[int, int] = (480, 270), camera: Optional[Sequence] = None, **marks):
        world = run if isinstance(run, World) else run.world
        self.frames_per_second, self.frames = frames_per_second, []
        start, count = world.time, int(round(seconds * frames_per_second))
        for i in range(count + 1):
            while world.time < start + i / frames_per_second - 1e-9:
                run.step()
            self.frames.append(png(picture(world, size, camera, **marks)))

    def _repr_html_(self) -> str:
        images = [f"data:image/png;base64,{base64.b64encode(frame).decode()}" for frame in self.frames]
        return _PLAYER.format(first=images[0], last=len(images) - 1, images=json.dumps(images), wait=1000 / self.frames_per_second)


_PLAYER = """<div><img src="{first}" style="display:block">
<button>Play</button> <input type="range" min="0" max="{last}" value="0" style="width:400px">
<script>{{
  const box = document.currentScript.parentElement, images = {images};
  const [image, button, slider] = ["img", "button", "input"].map(kind => box.querySelector(kind));
  const show = () => image.src = images[slider.value];
  let timer = null;
  const stop = () => {{ clearInterval(timer); timer = null; button.textContent = "Play"; }};
  slider.oninput = show;
  button.onclick = () => {{
    if (timer) return stop();
    if (slider.value == slider.max) slider.value = 0;
    button.textContent = "Stop";
    timer = setInterval(() => {{ slider.value++; show(); if (slider.value == slider.max) stop(); }}, {wait});
  }};
}}</script></div>"""

setattr(World, "_repr_html_", _html)
setattr(Session, "_repr_html_", lambda session: _html(session.world, session.name))
