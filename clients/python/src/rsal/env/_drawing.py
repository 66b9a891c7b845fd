"""A picture of a world, without a library for drawings."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from rsal.env._episodes import Episodes
from rsal.env._worlds import Worlds
from rsal.launch import RsalError

_WIDTH = 800  # pixels, at most
_BACKGROUND, _WALL, _UNKNOWN = (255, 255, 255), (40, 44, 52), (205, 205, 205)
_RADIUS = 0.3  # m
_LEAST = 4  # pixels

Picture = npt.NDArray[np.uint8]


class Pictures:
    """What an environment with one world shows of itself."""

    def __init__(self, episodes: Episodes, render_mode: str | None) -> None:
        if render_mode == "human":
            raise RsalError(
                "render_mode 'human' would need a window, and this environment opens none. Use 'rgb_array', whose "
                "pictures render() returns; for those of gymnasium.make, Gymnasium shows them in a window of pygame."
            )
        if render_mode not in (None, "rgb_array"):
            raise RsalError(f"render_mode must be 'rgb_array' or None, not '{render_mode}'.")
        self._episodes = episodes
        self._wanted = render_mode is not None
        self._drawing: Drawing | None = None

    def render(self) -> Picture | None:
        """Return a picture of the map and the robots, if the render mode is ``rgb_array``."""
        if not self._wanted:
            return None
        worlds = self._episodes.worlds
        if self._drawing is None:
            self._drawing = Drawing(worlds)
        return self._drawing.draw(worlds.poses[0])


class Drawing:
    """Draws robots on the map of their world: in their colors of the page, learners with a dark rim."""

    def __init__(self, worlds: Worlds) -> None:
        cells, resolution, self._origin = worlds.map()
        shrink = max(1, -(-cells.shape[1] // _WIDTH))
        rows, columns = (-(-size // shrink) * shrink for size in cells.shape)
        padded = np.full((rows, columns), -1, np.int8)
        padded[: cells.shape[0], : cells.shape[1]] = cells
        blocks = padded.reshape(rows // shrink, shrink, columns // shrink, shrink)
        wall, free = (blocks > 50).any((1, 3)), (blocks == 0).any((1, 3))  # noqa: PLR2004 - occupied in ROS
        grow = max(1, _WIDTH // (2 * wall.shape[1]))
        shown = np.empty((*wall.shape, 3), np.uint8)
        shown[:] = _UNKNOWN
        shown[free] = _BACKGROUND
        shown[wall] = _WALL
        self._floor: Picture = np.ascontiguousarray(shown[::-1].repeat(grow, 0).repeat(grow, 1))
        self._scale = grow / (resolution * shrink)  # pixels per m
        layout = worlds.layout
        self._colors = [_channels(layout.colors[robot]) for robot in layout.robots]
        self._learns = [robot in layout.learners for robot in layout.robots]

    def draw(self, poses: npt.NDArray[np.float32]) -> Picture:
        """Return a picture by rows from above, with red, green and blue from 0 to 255."""
        picture: Picture = self._floor.copy()
        height = picture.shape[0]
        radius = max(_LEAST, _RADIUS * self._scale)
        for (x, y, theta), color, learns in zip(poses, self._colors, self._learns, strict=True):
            column = (x - self._origin[0]) * self._scale
            row = height - (y - self._origin[1]) * self._scale
            _disc(picture, column, row, radius + 1.5, (30, 30, 30) if learns else (255, 255, 255))
            _disc(picture, column, row, radius, color)
            nose = 0.6 * radius
            _disc(picture, column + nose * np.cos(theta), row - nose * np.sin(theta), 0.3 * radius, (255, 255, 255))
        return picture


def _channels(color: str) -> tuple[int, int, int]:
    """Return red, green and blue of ``#rrggbb``."""
    red, green, blue = bytes.fromhex(color.removeprefix("#"))
    return red, green, blue


def _disc(picture: Picture, column: float, row: float, radius: float, color: tuple[int, int, int]) -> None:
    height, width, _ = picture.shape
    left, right = max(0, int(column - radius)), min(width, int(column + radius) + 2)
    top, bottom = max(0, int(row - radius)), min(height, int(row + radius) + 2)
    if left < right and top < bottom:
        y, x = np.ogrid[top:bottom, left:right]
        picture[top:bottom, left:right][(x - column) ** 2 + (y - row) ** 2 <= radius**2] = color
