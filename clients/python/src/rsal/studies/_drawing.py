"""Draws runs as SVG, without a library for plots."""

from __future__ import annotations

import base64
import math
import struct
import zlib
from collections.abc import Callable, Mapping
from html import escape

import numpy as np
from numpy.typing import NDArray

_MARGIN = 0.5  # m, around what is drawn
_POINTS = 2000  # of a way at most
_DASHES = ("none", "8 3", "2 3", "12 3 2 3")  # of robots with the same color
_WALL, _UNKNOWN, _FREE = 0x40, 0xE0, 0xFF  # gray


def drawn(
    cells: NDArray[np.int8],
    resolution: float,
    origin: tuple[float, float],
    ways: Mapping[str, tuple[str, NDArray[np.float64]]],
    *,
    title: str,
    width: int,
) -> str:
    """Return a map with ways of robots.

    Args:
        cells: of the map, row 0 at the lowest y.
        resolution: side of a cell [m].
        origin: of the map's lower left corner [m].
        ways: by robot its color, and its poses (n, 3).
        title: is shown above.
        width: of the picture [px].

    """
    rows, columns = np.nonzero(cells >= 0)
    if len(rows):  # what is known of the map, and a margin
        around = max(1, round(_MARGIN / resolution))
        low, high = max(0, int(rows.min()) - around), min(cells.shape[0], int(rows.max()) + 1 + around)
        left, right = max(0, int(columns.min()) - around), min(cells.shape[1], int(columns.max()) + 1 + around)
    else:
        low, high, left, right = 0, cells.shape[0], 0, cells.shape[1]
    part = cells[low:high, left:right]
    x0, y0 = origin[0] + left * resolution, origin[1] + low * resolution
    across, up = part.shape[1] * resolution, part.shape[0] * resolution
    scale = width / across
    head = 24
    key = 20 * len(ways)
    height = math.ceil(up * scale) + head + 8 + key

    def point(x: float, y: float) -> str:
        return f"{(x - x0) * scale:.1f},{head + (y0 + up - y) * scale:.1f}"

    gray = np.where(part >= 50, _WALL, np.where(part < 0, _UNKNOWN, _FREE)).astype(np.uint8)  # noqa: PLR2004 - percent
    image = base64.b64encode(png(gray[::-1])).decode("ascii")
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
        'font-family="sans-serif" font-size="13">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
        f'<text x="4" y="16">{escape(title)}</text>',
        f'<image y="{head}" width="{width}" height="{up * scale:.1f}" preserveAspectRatio="none" '
        f'href="data:image/png;base64,{image}"/>',
    ]
    drawn_with: dict[str, int] = {}
    for number, (robot, (color, poses)) in enumerate(ways.items()):
        name, paint = escape(robot), escape(color)
        dashes = f' stroke-dasharray="{_DASHES[drawn_with.get(color, 0) % len(_DASHES)]}"'
        drawn_with[color] = drawn_with.get(color, 0) + 1
        if len(poses):
            step = max(1, math.ceil(len(poses) / _POINTS))
            shown = np.vstack([poses[::step], poses[-1:]])
            path = " ".join(point(x, y) for x, y, _ in shown)
            lines.append(
                f'<polyline points="{path}" fill="none" stroke="{paint}" stroke-width="2" stroke-linejoin="round"'
                f"{dashes}><title>{name}</title></polyline>"
            )
            lines.append(_dot(point(*poses[0, :2]), paint))
            lines.append(_arrow(poses[-1], point, paint, 14 / scale))
        y = height - key + 20 * number + 8
        lines.append(f'<line x1="8" y1="{y}" x2="32" y2="{y}" stroke="{paint}" stroke-width="3"{dashes}/>')
        lines.append(f'<text x="38" y="{y + 4}">{name}</text>')
    bar = 10 ** math.floor(math.log10(max(across / 4, resolution)))
    lines.append(
        f'<line x1="{width - 8 - bar * scale:.1f}" y1="18" x2="{width - 8}" y2="18" stroke="black" stroke-width="2"/>'
        f'<text x="{width - 8}" y="13" text-anchor="end" font-size="11">{bar:g} m</text>'
    )
    return "\n".join([*lines, "</svg>"])


def _dot(at: str, color: str) -> str:
    x, y = at.split(",")
    return f'<circle cx="{x}" cy="{y}" r="4" fill="white" stroke="{color}" stroke-width="2"/>'


def _arrow(pose: NDArray[np.float64], point: Callable[[float, float], str], color: str, size: float) -> str:
    x, y, theta = pose
    corners = [(theta, size), (theta + 2.5, 0.6 * size), (theta - 2.5, 0.6 * size)]
    path = " ".join(point(x + far * math.cos(angle), y + far * math.sin(angle)) for angle, far in corners)
    return f'<polygon points="{path}" fill="{color}" stroke="black" stroke-width="0.8"/>'


def png(gray: NDArray[np.uint8]) -> bytes:
    """Return a picture as PNG (RFC 2083), 8 bits of gray.

    Args:
        gray: ``gray[row, column]``, the top row first.

    """

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width = gray.shape
    filtered = np.zeros((height, width + 1), np.uint8)  # each row begins with its filter, 0 for none
    filtered[:, 1:] = gray
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
        + chunk(b"IDAT", zlib.compress(filtered.tobytes(), 9))
        + chunk(b"IEND", b"")
    )
