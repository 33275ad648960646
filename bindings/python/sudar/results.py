"""What questions about a world come back as: tuples with names. Vectors are numpy arrays of float64 with shape (3,),
in world axes, SI units."""

from typing import TYPE_CHECKING, List, NamedTuple, Optional

import numpy as np

if TYPE_CHECKING:
    from ._core import Body, ShapeId


class Touch(NamedTuple):
    """Two bodies that began or ceased to touch, with one shape each."""
    a: "Body"
    b: "Body"
    shape_a: "ShapeId"
    shape_b: "ShapeId"


class Hit(NamedTuple):
    """An impact."""
    a: "Body"
    b: "Body"
    at: np.ndarray
    """m"""
    normal: np.ndarray
    """unit vector, from b to a"""
    speed: float
    """of approach, m/s"""


class Quarantined(NamedTuple):
    """A body whose state turned non-finite: it is frozen where it last was finite, and no longer collides."""
    body: "Body"
    reason: str


class Events(NamedTuple):
    """What the last step reported."""
    begun: List[Touch]
    ended: List[Touch]
    hits: List[Hit]
    quarantined: List[Quarantined]


class ContactPoint(NamedTuple):
    at: np.ndarray
    """m"""
    separation: float
    """m; negative: overlap"""
    normal_impulse: float
    """N·s, of the last sub-step"""
    friction: np.ndarray
    """N·s, on a"""
    cone_share: float
    """|friction| / (friction_static · normal_impulse): 1 is the edge of the cone"""


class Contact(NamedTuple):
    """One touching pair of shapes, as the last sub-step left it."""
    a: "Body"
    b: "Body"
    normal: np.ndarray
    """unit vector, from b to a"""
    points: List[ContactPoint]
    friction_static: float
    friction_dynamic: float
    restitution: float
    slipping: bool
    """friction is at the edge of its cone, and the bodies move along each other"""
    shape_a: "ShapeId"
    shape_b: "ShapeId"


class RayHit(NamedTuple):
    body: "Body"
    at: np.ndarray
    """m"""
    normal: np.ndarray
    """of the surface, unit vector"""
    distance: float
    """m"""
    shape: "ShapeId"


class Distance(NamedTuple):
    """Between two shapes."""
    value: float
    """m; negative where they overlap: the shortest way that one must be moved to part them"""
    normal: np.ndarray
    """unit vector from b to a, along which they part soonest"""
    on_a: np.ndarray
    on_b: np.ndarray


class Energy(NamedTuple):
    """Of all dynamic bodies, J. Potential: in Gravity and NBody."""
    kinetic: float
    potential: float

    @property
    def total(self) -> float:
        return self.kinetic + self.potential


class Momentum(NamedTuple):
    """Of all dynamic bodies: linear [N·s], and angular about the origin [N·m·s]."""
    linear: np.ndarray
    angular: np.ndarray


class Load(NamedTuple):
    """What a joint exerted on its body b in the last sub-step, about its anchor there: N and N·m."""
    force: np.ndarray
    torque: np.ndarray


class Quality(NamedTuple):
    """How well the last step's constraints hold, m."""
    penetration_max: float
    penetration_mean: float
    joint_gap_max: float
    joint_gap_mean: float


class MassProperties(NamedTuple):
    volume: float
    """m³"""
    center: np.ndarray
    """of mass, in the shape's frame, m"""
    inertia: np.ndarray
    """(3, 3), about the centre of mass, per unit density, m⁵"""


class Difference(NamedTuple):
    """The first field in which two worlds differ, with both values as JSON."""
    field: str
    body: Optional["Body"]
    row: int
    """of its table: the number of the body, joint or pair; −1: it has no table"""
    a: str
    b: str


class Divergence(NamedTuple):
    """Where a replay first differs from its recording."""
    step: int
    stage: str
    field: str
    body: Optional["Body"]


class ScenarioInfo(NamedTuple):
    name: str
    place: str
    """"Group/Title" in the browser of the program"""
    about: str
    seconds: float
    """that its checks need, simulated"""


class Parameter(NamedTuple):
    name: str
    kind: str
    """"integer", "real" or "boolean\""""
    value: float
    low: float
    high: float
    about: str
    """unit or meaning"""


class Check(NamedTuple):
    """One expectation of a scenario."""
    name: str
    op: str
    value: float
    limit: float
    tolerance: float
    unit: str
    at: float
    """simulated time of the value, s"""
    passed: Optional[bool]
    """None: its time was not reached"""
