"""What learners observe of messages."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from rsal import RsalError, env
from rsal.env import Observe

_SCENARIO = """
rsal: 1
scenario: talking
world: {map: office}
robots:
  learner: {count: 2, model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx}}
  other: {model: pioneer2dx, pose: [-20, 4, 0], devices: {laser: urg04lx, pilot: {}, localizer: {type: odometry}}}
agents:
  drive: {type: wander, robot: other}
  bidder: {type: bidder.py}
"""
_BIDDER = """
import rsal

BIDS = rsal.Topic("bids", dict)


class Bidder(rsal.Agent):
    def on_start(self):
        self.count = 0
        self.every(0.2, self.bid)

    def bid(self):
        self.count += 1
        self.publish(BIDS, {"price": self.count, "is_last": False, "robot": {"x": self.random.random()}})
"""


@pytest.fixture
def talking(tmp_path: Path) -> Path:
    (tmp_path / "bidder.py").write_text(_BIDDER, encoding="utf-8")
    file = tmp_path / "talking.yaml"
    file.write_text(_SCENARIO, encoding="utf-8")
    return file


def _observe() -> list[dict[str, object]]:
    return [
        Observe.messages("pose", ["map_from_base.x", "map_from_base.y"], source="drive"),
        Observe.messages("bids", ["price", "robot.x"], newest=3, reach=4),
    ]


def test_learners_observe_what_others_say(talking: Path) -> None:
    made = env.make_vec(talking, num_envs=2, learners="learner", observe=_observe(), threads=2)
    alone = env.make_vec(talking, num_envs=1, learners="learner", observe=_observe())
    seen, _ = made.reset(seed=[3, 4])
    first, _ = alone.reset(seed=[4])
    still = np.zeros(made.action_shape, np.float32)
    for _ in range(14):
        assert seen[1].tobytes() == first[0].tobytes()
        seen, *_ = made.step(still)
        first, *_ = alone.step(still[:1])
    other = seen[0, 0]
    assert tuple(other[:2]) == pytest.approx((-20, 4), abs=1)
    assert other[3] == 1
    price, x, age, exists = other[4:].reshape(3, 4).T
    assert price.tolist() == [4, 4, 4]  # of 7, 6 and 5
    assert age.tolist() == pytest.approx([0.1, 0.3, 0.5])
    assert exists.tolist() == [1, 1, 1]
    assert len(set(x.tolist())) == 3
    assert np.array_equal(seen[0, 0], seen[0, 1])
    assert not np.array_equal(seen[0, 0], seen[1, 0])
    assert made.layout.fields[4:8] == (
        "price of message 1",
        "robot.x of message 1",
        "age of message 1 [s]",
        "message 1 exists",
    )
    assert made.layout.high[4:8].tolist() == [4, 4, 1000, 1]
    made.close()
    alone.close()


def test_wrong_names_in_messages_are_errors(talking: Path) -> None:
    with pytest.raises(RsalError, match=r"no number 'map_from_bas\.x'.*Maybe 'map_from_base' was meant"):
        env.make_vec(
            talking, num_envs=1, learners="learner", observe=[Observe.messages("pose", ["map_from_bas.x"])]
        ).reset()
    made = env.make_vec(talking, num_envs=1, learners="learner", steps=5, observe=[Observe.messages("bids", ["prise"])])
    made.reset(seed=1)  # what dicts have is known only when one was said
    with pytest.raises(RsalError, match=r"'bids' have no number 'prise'\. Maybe 'price' was meant"):
        made.step(np.zeros(made.action_shape))
    made.close()
