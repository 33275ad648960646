# Written by bindings/python/tools/stubs.py.
from os import PathLike
from typing import Any, Dict, Iterator, List, Literal, Optional, Sequence, Union, overload

import numpy as np

from .results import Touch, Hit, Quarantined, Events, ContactPoint, Contact, RayHit, Distance, Energy, Momentum, Load, Quality, MassProperties, Difference, Divergence, ScenarioInfo, Parameter, Check

Array = np.ndarray
"""float64"""
Numbers = Union[Sequence[float], np.ndarray]
NumberRows = Union[Sequence[Sequence[float]], np.ndarray]

__version__: str
precision: Literal["float", "double"]

class Error(ValueError):
    """Bad data: a definition, a file, a setting. Whatever raised it has changed nothing. `field` names what was wrong."""
    field: str

class Shape:
    """An immutable form in its own frame, m. Made by sphere(), box(), hull() and so on."""
    @property
    def kind(self) -> str: ...
    @property
    def radius(self) -> float:
        """m; 0 of a half space, a hull, an ellipsoid"""
    @property
    def half_length(self) -> float:
        """along y, m: half of a capsule's segment, half the height of a cylinder or cone; else 0"""
    @property
    def radii(self) -> Array:
        """of an ellipsoid, m; else 0"""
    @property
    def bounding_radius(self) -> float:
        """about the origin, m; infinite of a half space"""
    @property
    def mass_properties(self) -> MassProperties: ...
    @property
    def vertices(self) -> Array:
        """of a hull or mesh: (n, 3), m"""
    @property
    def faces(self) -> List[List[int]]:
        """of a hull or mesh: lists of numbers of vertices, counter-clockwise seen from outside"""
    def __bool__(self) -> bool: ...
    def __eq__(self, __other: object) -> bool: ...
    def __repr__(self) -> str: ...

def sphere(radius: float) -> Shape: ...

def capsule(radius: float, length: float) -> Shape:
    """`length` of the segment between the two centres, along y"""

@overload
def cylinder(radius: float, height: float) -> Shape:
    """axis y, centred"""
@overload
def cylinder(radius: float, height: float, sides: int) -> Shape:
    """axis y, centred"""

@overload
def cone(radius: float, height: float) -> Shape:
    """axis y, apex up; the origin is the centre of mass, height/4 above the base"""
@overload
def cone(radius: float, height: float, sides: int) -> Shape:
    """axis y, apex up; the origin is the centre of mass, height/4 above the base"""

def ellipsoid(radii: Numbers) -> Shape: ...

def half_space() -> Shape:
    """everything below y = 0 of its frame: an infinite floor; fixed bodies only"""

def hollow_sphere(radius: float) -> Shape: ...

def hollow_cylinder(radius: float, height: float) -> Shape: ...

def box(edges: Numbers) -> Shape:
    """full edges"""

def prism(sides: int, radius: float, height: float) -> Shape:
    """regular; axis y, a vertex at +x; circumradius"""

def pyramid(sides: int, radius: float, height: float) -> Shape:
    """axis y, apex up, a base vertex at +x"""

def uv_sphere(radius: float, slices: int = ..., stacks: int = ...) -> Shape: ...

def tetrahedron(edge: float) -> Shape: ...

def octahedron(edge: float) -> Shape: ...

def dodecahedron(edge: float) -> Shape: ...

def icosahedron(edge: float) -> Shape: ...

def truncated_icosahedron(edge: float) -> Shape:
    """the football"""

def wedge(edges: Numbers) -> Shape:
    """right triangle (0,0),(x,0),(0,y) extruded to z, centred on its centre of mass"""

def hull(points: List[Numbers]) -> Shape:
    """their convex hull, where they are"""

def mesh(vertices: List[Numbers], triangles: List[List[int]]) -> Shape:
    """a surface of triangles, for fixed and kinematic bodies"""

def extrude(outline: List[Numbers], height: float) -> Shape:
    """convex outline in the xy plane (z ignored), extruded along z; kept where it is in x and y"""

class Body:
    """A body of a world. Its attributes ask the world; those that may be set change it."""
    def remove(self) -> None:
        """Takes it out of its world."""
    @property
    def index(self) -> int:
        """its slot in the world"""
    def __eq__(self, __other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    @property
    def alive(self) -> bool:
        """false once it was removed"""
    @property
    def position(self) -> Array:
        """of the shape's frame, m; setting it moves the body there"""
    @position.setter
    def position(self, value: Numbers) -> None: ...
    @property
    def orientation(self) -> Array:
        """of the shape's frame: unit quaternion x, y, z, w; may be set"""
    @orientation.setter
    def orientation(self, value: Numbers) -> None: ...
    @property
    def velocity(self) -> Array:
        """of the centre of mass, m/s; may be set"""
    @velocity.setter
    def velocity(self, value: Numbers) -> None: ...
    @property
    def spin(self) -> Array:
        """angular velocity, rad/s, world axes; may be set"""
    @spin.setter
    def spin(self, value: Numbers) -> None: ...
    @property
    def surface_velocity(self) -> Array:
        """of the surface along itself, like a belt's: m/s, shape's axes; may be set"""
    @surface_velocity.setter
    def surface_velocity(self, value: Numbers) -> None: ...
    @property
    def center(self) -> Array:
        """of mass, m"""
    @property
    def angular_momentum(self) -> Array:
        """about the centre of mass, world axes, N·m·s"""
    @property
    def mass(self) -> float:
        """kg; 0 of a half space"""
    @property
    def inertia(self) -> Array:
        """(3, 3), about the centre of mass, world axes, kg·m²"""
    @property
    def kinetic_energy(self) -> float:
        """J"""
    @property
    def shape(self) -> Shape: ...
    @property
    def material(self) -> Material:
        """a copy"""
    @property
    def shapes(self) -> List[ShapeId]:
        """all, in the order in which it got them; `shape` and `material` are those of the first"""
    def add_shape(self, *,
        shape: Shape = ...,
        at: Numbers = ...,
        turn: Numbers = ...,
        density: Optional[float] = ...,
        material: Optional[Union[Material, Dict[str, Any]]] = ...,
        surface_velocity: Optional[Numbers] = ...,
        filter: Optional[Union[Filter, Dict[str, Any]]] = ...,) -> ShapeId:
        """One more, given by the fields of ShapeDef by name. Mass and inertia are made anew; the body goes on as it went."""
    @property
    def name(self) -> str: ...
    @property
    def motion(self) -> str:
        """"dynamic", "kinematic" or "fixed\""""
    @property
    def asleep(self) -> bool: ...
    @property
    def quarantined(self) -> bool:
        """its state turned non-finite: it is frozen"""
    def velocity_at(self, point: Numbers) -> Array:
        """of a point of the body [m, world]: m/s"""
    def push(self, force: Numbers, at: Optional[Numbers] = ...) -> None:
        """A force [N, world axes] during the next step only, at a point [m]; None: the centre of mass."""
    def twist(self, torque: Numbers) -> None:
        """A torque [N·m, world axes] during the next step only."""
    def wake(self) -> None: ...
    def touches(self, other: Body) -> bool: ...
    def distance(self, other: Body) -> Distance:
        """To the other body's shape, touching or not."""

class ShapeId:
    """One of the shapes of a body. A body keeps at least one."""
    def remove(self) -> None:
        """Takes it out of its world."""
    @property
    def index(self) -> int:
        """its slot in the world"""
    def __eq__(self, __other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    @property
    def alive(self) -> bool:
        """false once it was removed"""
    @property
    def body(self) -> Body: ...
    @property
    def shape(self) -> Shape: ...
    @property
    def position(self) -> Array:
        """of its frame, m"""
    @property
    def orientation(self) -> Array:
        """of its frame: unit quaternion x, y, z, w"""
    @property
    def at(self) -> Array:
        """of its frame, in the body's, m"""
    @property
    def turn(self) -> Array:
        """of its frame, against the body's"""
    @property
    def density(self) -> float:
        """kg/m³"""
    @property
    def material(self) -> Material:
        """a copy"""
    @property
    def filter(self) -> Filter:
        """a copy"""
    @property
    def surface_velocity(self) -> Array:
        """m/s, shape's axes"""

class Joint:
    """A joint of a world."""
    def remove(self) -> None:
        """Takes it out of its world."""
    @property
    def index(self) -> int:
        """its slot in the world"""
    def __eq__(self, __other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    @property
    def alive(self) -> bool:
        """false once it was removed"""
    @property
    def definition(self) -> Union[Bar, Rope, Ball, Hinge, Slider, Fixed, Plane, Muscle, Pulley, Reel, Orientation, Azimuth, Tilt, Stroke]:
        """a copy of what it was made from, with its present drive"""
    @property
    def a(self) -> Optional[Body]:
        """None: the world"""
    @property
    def b(self) -> Optional[Body]:
        """None: the world"""
    @property
    def anchor_a(self) -> Array:
        """as it is now, m"""
    @property
    def anchor_b(self) -> Array:
        """as it is now, m"""
    @property
    def gap(self) -> float:
        """how far the joint is from holding, m"""
    @property
    def coordinate(self) -> float:
        """angle of a hinge [rad, unwound], way of a slider, length of a rope or muscle [m]; else 0"""
    @property
    def load(self) -> Load:
        """that it exerted on its body b in the last sub-step: N and N·m about anchor b"""
    @property
    def drive(self) -> Drive:
        """of a joint that has one: a copy, which may be changed and set"""
    @drive.setter
    def drive(self, value: Union[Drive, Dict[str, Any]]) -> None: ...

class ForceId:
    """A force that acts in a world until it is removed."""
    def remove(self) -> None:
        """Takes it out of its world."""
    @property
    def index(self) -> int:
        """its slot in the world"""
    def __eq__(self, __other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    @property
    def definition(self) -> Union[Gravity, Drag, NBody, Thruster]:
        """a copy"""

class SensorId:
    """A sensor of a world."""
    def remove(self) -> None:
        """Takes it out of its world."""
    @property
    def index(self) -> int:
        """its slot in the world"""
    def __eq__(self, __other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def __repr__(self) -> str: ...
    @property
    def definition(self) -> Sensor:
        """a copy"""
    @property
    def value(self) -> float:
        """after the last step, in the unit of its kind"""

class Material:
    friction_static: float
    """Coulomb, largest tangential / normal force without slip"""
    friction_dynamic: float
    """the same while slipping"""
    restitution: float
    """relative normal speed after / before an impact"""
    rolling: float
    """m: torque that resists rolling / normal force"""
    spinning: float
    """m: torque that resists spinning about the normal / normal force"""
    def __init__(self, *,
        friction_static: float = ...,
        friction_dynamic: float = ...,
        restitution: float = ...,
        rolling: float = ...,
        spinning: float = ...,) -> None: ...
    def replace(self, *,
        friction_static: float = ...,
        friction_dynamic: float = ...,
        restitution: float = ...,
        rolling: float = ...,
        spinning: float = ...,) -> Material:
        """A copy with other values in the named fields."""

class Filter:
    """Two bodies may touch when each one's category is in the other's mask; but bodies of the same non-zero group always touch if it is positive and never if it is negative."""
    category: int
    mask: int
    group: int
    def __init__(self, *,
        category: int = ...,
        mask: int = ...,
        group: int = ...,) -> None: ...
    def replace(self, *,
        category: int = ...,
        mask: int = ...,
        group: int = ...,) -> Filter:
        """A copy with other values in the named fields."""

class ShapeDef:
    """One of the shapes of a body that has several. What it leaves out is the body's."""
    shape: Shape
    at: Array
    """of the shape's frame, in the body's, m"""
    turn: Array
    """of the shape's frame, against the body's"""
    density: Optional[float]
    """kg/m³; parts of a body whose mass is given share it by volume times this"""
    material: Optional[Material]
    surface_velocity: Optional[Array]
    """m/s, shape's axes"""
    filter: Optional[Filter]
    def __init__(self, *,
        shape: Shape = ...,
        at: Numbers = ...,
        turn: Numbers = ...,
        density: Optional[float] = ...,
        material: Optional[Union[Material, Dict[str, Any]]] = ...,
        surface_velocity: Optional[Numbers] = ...,
        filter: Optional[Union[Filter, Dict[str, Any]]] = ...,) -> None: ...
    def replace(self, *,
        shape: Shape = ...,
        at: Numbers = ...,
        turn: Numbers = ...,
        density: Optional[float] = ...,
        material: Optional[Union[Material, Dict[str, Any]]] = ...,
        surface_velocity: Optional[Numbers] = ...,
        filter: Optional[Union[Filter, Dict[str, Any]]] = ...,) -> ShapeDef:
        """A copy with other values in the named fields."""

class BodyDef:
    """A body's frame is that of its shape; where it has several, each lies in the body's frame. Its mass, centre and inertia are the sums over its shapes, as if they did not overlap."""
    shape: Shape
    shapes: Sequence[ShapeDef]
    """of a body that has several, instead of `shape`"""
    at: Array
    """of the body's frame, m"""
    turn: Array
    """of the body's frame"""
    velocity: Array
    """of the centre of mass, m/s"""
    spin: Array
    """angular velocity, rad/s, world axes"""
    density: float
    """kg/m³; used where mass is 0"""
    mass: float
    """kg; 0: from density"""
    center: Optional[Array]
    """of mass, in the body's frame, m; none: the shapes'"""
    inertia: Optional[Array]
    """about the centre of mass, body's axes, kg m²; none: the shapes'"""
    material: Material
    surface_velocity: Array
    """of the surface along itself while the body stands, like a belt's; m/s, body's axes"""
    filter: Filter
    motion: Literal["dynamic", "kinematic", "fixed"]
    gravity_factor: float
    """times what Gravity does to it: 0 for what floats, negative for what rises"""
    sleeps: bool
    """may be put to sleep where the world sleeps"""
    name: str
    def __init__(self, *,
        shape: Shape = ...,
        shapes: Sequence[Union[ShapeDef, Dict[str, Any]]] = ...,
        at: Numbers = ...,
        turn: Numbers = ...,
        velocity: Numbers = ...,
        spin: Numbers = ...,
        density: float = ...,
        mass: float = ...,
        center: Optional[Numbers] = ...,
        inertia: Optional[NumberRows] = ...,
        material: Union[Material, Dict[str, Any]] = ...,
        surface_velocity: Numbers = ...,
        filter: Union[Filter, Dict[str, Any]] = ...,
        motion: Literal["dynamic", "kinematic", "fixed"] = ...,
        gravity_factor: float = ...,
        sleeps: bool = ...,
        name: str = ...,) -> None: ...
    def replace(self, *,
        shape: Shape = ...,
        shapes: Sequence[Union[ShapeDef, Dict[str, Any]]] = ...,
        at: Numbers = ...,
        turn: Numbers = ...,
        velocity: Numbers = ...,
        spin: Numbers = ...,
        density: float = ...,
        mass: float = ...,
        center: Optional[Numbers] = ...,
        inertia: Optional[NumberRows] = ...,
        material: Union[Material, Dict[str, Any]] = ...,
        surface_velocity: Numbers = ...,
        filter: Union[Filter, Dict[str, Any]] = ...,
        motion: Literal["dynamic", "kinematic", "fixed"] = ...,
        gravity_factor: float = ...,
        sleeps: bool = ...,
        name: str = ...,) -> BodyDef:
        """A copy with other values in the named fields."""

class Bar:
    """keeps the distance between two points: thesis (3.22)"""
    a: Optional[Body]
    b: Optional[Body]
    at_a: Array
    at_b: Array
    collide: bool
    """may the two bodies touch each other?"""
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        at_b: Numbers = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        at_b: Numbers = ...,
        collide: bool = ...,) -> Bar:
        """A copy with other values in the named fields."""

class Rope:
    """keeps the distance between two points at most at `length`; 0: the distance at creation"""
    a: Optional[Body]
    b: Optional[Body]
    at_a: Array
    at_b: Array
    length: float
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        at_b: Numbers = ...,
        length: float = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        at_b: Numbers = ...,
        length: float = ...,
        collide: bool = ...,) -> Rope:
        """A copy with other values in the named fields."""

class Ball:
    """keeps two points together: thesis (3.23), fig. 3"""
    a: Optional[Body]
    b: Optional[Body]
    at: Array
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        collide: bool = ...,) -> Ball:
        """A copy with other values in the named fields."""

class Limit:
    """The free coordinate of a hinge [rad] or slider [m], 0 at creation, is kept within low…high."""
    low: float
    high: float
    def __init__(self, *,
        low: float = ...,
        high: float = ...,) -> None: ...
    def replace(self, *,
        low: float = ...,
        high: float = ...,) -> Limit:
        """A copy with other values in the named fields."""

class Drive:
    mode: Literal["off", "speed", "servo", "spring"]
    target: float
    force: float
    max_speed: float
    """of a servo, m/s or rad/s"""
    stiffness: float
    """of a spring, N/m and N s/m, or N m/rad and N m s/rad"""
    damping: float
    """of a spring, N/m and N s/m, or N m/rad and N m s/rad"""
    rate: float
    """of a spring, at which damping does nothing: m/s or rad/s"""
    armature: float
    """of a spring: inertia along the coordinate alone, as of a rotor behind a gear, kg or kg m²"""
    def __init__(self, *,
        mode: Literal["off", "speed", "servo", "spring"] = ...,
        target: float = ...,
        force: float = ...,
        max_speed: float = ...,
        stiffness: float = ...,
        damping: float = ...,
        rate: float = ...,
        armature: float = ...,) -> None: ...
    def replace(self, *,
        mode: Literal["off", "speed", "servo", "spring"] = ...,
        target: float = ...,
        force: float = ...,
        max_speed: float = ...,
        stiffness: float = ...,
        damping: float = ...,
        rate: float = ...,
        armature: float = ...,) -> Drive:
        """A copy with other values in the named fields."""

class Hinge:
    """a ball joint that turns about one axis only: thesis (3.24), fig. 3"""
    a: Optional[Body]
    b: Optional[Body]
    at: Array
    axis: Array
    limit: Limit
    drive: Drive
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> Hinge:
        """A copy with other values in the named fields."""

class Slider:
    """b slides along the axis, without turning against a"""
    a: Optional[Body]
    b: Optional[Body]
    at: Array
    axis: Array
    limit: Limit
    drive: Drive
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> Slider:
        """A copy with other values in the named fields."""

class Fixed:
    """b does not move against a"""
    a: Optional[Body]
    b: Optional[Body]
    at: Array
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        collide: bool = ...,) -> Fixed:
        """A copy with other values in the named fields."""

class Plane:
    """keeps a point of b in a plane of a"""
    a: Optional[Body]
    b: Optional[Body]
    at: Array
    normal: Array
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        normal: Numbers = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        normal: Numbers = ...,
        collide: bool = ...,) -> Plane:
        """A copy with other values in the named fields."""

class Muscle:
    """drives the distance between two points"""
    a: Optional[Body]
    b: Optional[Body]
    at_a: Array
    at_b: Array
    drive: Drive
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        at_b: Numbers = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        at_b: Numbers = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> Muscle:
        """A copy with other values in the named fields."""

class Pulley:
    """a rope from a over two points of the world to b: |at_a − over_a| + ratio |at_b − over_b| ≤ length"""
    a: Optional[Body]
    b: Optional[Body]
    at_a: Array
    over_a: Array
    over_b: Array
    at_b: Array
    ratio: float
    """of a block and tackle: b rises by 1/ratio of what a sinks"""
    length: float
    """m; 0: that at creation"""
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        over_a: Numbers = ...,
        over_b: Numbers = ...,
        at_b: Numbers = ...,
        ratio: float = ...,
        length: float = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        over_a: Numbers = ...,
        over_b: Numbers = ...,
        at_b: Numbers = ...,
        ratio: float = ...,
        length: float = ...,
        collide: bool = ...,) -> Pulley:
        """A copy with other values in the named fields."""

class Reel:
    """a rope from a that winds on an axle of b, without slipping; taut at creation"""
    a: Optional[Body]
    b: Optional[Body]
    at_a: Array
    """where it is tied"""
    at: Array
    """on the axle's line"""
    axis: Array
    """of the axle; b turning about it in the positive sense lets rope out"""
    radius: float
    """of the axle, m"""
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        radius: float = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at_a: Numbers = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        radius: float = ...,
        collide: bool = ...,) -> Reel:
        """A copy with other values in the named fields."""

class Orientation:
    """b does not turn against a, and goes where it likes"""
    a: Optional[Body]
    b: Optional[Body]
    at: Array
    """where it is shown"""
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        collide: bool = ...,) -> Orientation:
        """A copy with other values in the named fields."""

class Azimuth:
    """the angle of a direction of b about an axis of a; 0 at creation, unwound"""
    a: Optional[Body]
    b: Optional[Body]
    at: Array
    """where it is shown"""
    axis: Array
    """of a"""
    direction: Array
    """of b, not along the axis"""
    limit: Limit
    drive: Drive
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        direction: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        direction: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> Azimuth:
        """A copy with other values in the named fields."""

class Tilt:
    """the angle between an axis of a and a direction of b: 0…π, also in limit and drive"""
    a: Optional[Body]
    b: Optional[Body]
    at: Array
    """where it is shown"""
    axis: Array
    direction: Array
    limit: Limit
    drive: Drive
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        direction: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        direction: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> Tilt:
        """A copy with other values in the named fields."""

class Stroke:
    """the way of a point of b along an axis of a, 0 at creation"""
    a: Optional[Body]
    b: Optional[Body]
    at: Array
    axis: Array
    limit: Limit
    drive: Drive
    collide: bool
    def __init__(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> None: ...
    def replace(self, *,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        at: Numbers = ...,
        axis: Numbers = ...,
        limit: Union[Limit, Dict[str, Any]] = ...,
        drive: Union[Drive, Dict[str, Any]] = ...,
        collide: bool = ...,) -> Stroke:
        """A copy with other values in the named fields."""

class Gravity:
    """the same everywhere: thesis (3.5)"""
    acceleration: Array
    """m/s²"""
    def __init__(self, *,
        acceleration: Numbers = ...,) -> None: ...
    def replace(self, *,
        acceleration: Numbers = ...,) -> Gravity:
        """A copy with other values in the named fields."""

class Drag:
    """Resistance of a still medium: F = −(A + B|v|) v and the angular twin, integrated implicitly, so that it never overshoots however long the step (thesis (3.6) with its direction restored)."""
    body: Optional[Body]
    """null: every body"""
    linear: float
    """A / m, 1/s"""
    quadratic: float
    """B / m, 1/m"""
    angular: float
    """1/s"""
    angular_quadratic: float
    """1/rad"""
    angular_per_radius: float
    """1/(m s): adds this times the body's bounding radius to `angular`"""
    def __init__(self, *,
        body: Optional[Body] = ...,
        linear: float = ...,
        quadratic: float = ...,
        angular: float = ...,
        angular_quadratic: float = ...,
        angular_per_radius: float = ...,) -> None: ...
    def replace(self, *,
        body: Optional[Body] = ...,
        linear: float = ...,
        quadratic: float = ...,
        angular: float = ...,
        angular_quadratic: float = ...,
        angular_per_radius: float = ...,) -> Drag:
        """A copy with other values in the named fields."""

class NBody:
    """every two bodies attract each other: F = G m₁ m₂ r / (r² + softening²)^(3/2) (H. Plummer 1911)"""
    gravitational_constant: float
    """m³/(kg s²)"""
    softening: float
    """m"""
    def __init__(self, *,
        gravitational_constant: float = ...,
        softening: float = ...,) -> None: ...
    def replace(self, *,
        gravitational_constant: float = ...,
        softening: float = ...,) -> NBody:
        """A copy with other values in the named fields."""

class Thruster:
    """a force that turns with the body"""
    body: Optional[Body]
    force: Array
    """N, body axes"""
    at: Array
    """m, body frame"""
    def __init__(self, *,
        body: Optional[Body] = ...,
        force: Numbers = ...,
        at: Numbers = ...,) -> None: ...
    def replace(self, *,
        body: Optional[Body] = ...,
        force: Numbers = ...,
        at: Numbers = ...,) -> Thruster:
        """A copy with other values in the named fields."""

class Sensor:
    kind: Literal["acceleration", "distance", "maximum_speed", "odometer"]
    a: Optional[Body]
    """b: null is the world's origin"""
    b: Optional[Body]
    """b: null is the world's origin"""
    name: str
    def __init__(self, *,
        kind: Literal["acceleration", "distance", "maximum_speed", "odometer"] = ...,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        name: str = ...,) -> None: ...
    def replace(self, *,
        kind: Literal["acceleration", "distance", "maximum_speed", "odometer"] = ...,
        a: Optional[Body] = ...,
        b: Optional[Body] = ...,
        name: str = ...,) -> Sensor:
        """A copy with other values in the named fields."""

class Impulse2007:
    """The thesis's solver (docs/thesis.md). N₁, N₂, b, δ_max as there."""
    collision_passes: int
    """N₁, at most"""
    contact_passes: int
    """N₂, at most"""
    correction: float
    """b, share of the overlap beyond slop that one sub-step removes"""
    slop: float
    """δ_max, m · length_unit"""
    joint_correction: float
    """b of joints"""
    joint_correction_in_velocity: bool
    """joints are pulled back in the real velocity, as in the prototype's net"""
    exact_joints: bool
    """joints of what touches nothing keep energy (RATTLE); else all by passes"""
    one_point_contact: bool
    """as in the thesis: a contact is one point, the centre of the overlap"""
    friction_per_increment: bool
    """as in the thesis: the friction cone is tested per increment"""
    shock_propagation: bool
    """a last sweep from the ground up, lower levels frozen"""
    def __init__(self, *,
        collision_passes: int = ...,
        contact_passes: int = ...,
        correction: float = ...,
        slop: float = ...,
        joint_correction: float = ...,
        joint_correction_in_velocity: bool = ...,
        exact_joints: bool = ...,
        one_point_contact: bool = ...,
        friction_per_increment: bool = ...,
        shock_propagation: bool = ...,) -> None: ...
    def replace(self, *,
        collision_passes: int = ...,
        contact_passes: int = ...,
        correction: float = ...,
        slop: float = ...,
        joint_correction: float = ...,
        joint_correction_in_velocity: bool = ...,
        exact_joints: bool = ...,
        one_point_contact: bool = ...,
        friction_per_increment: bool = ...,
        shock_propagation: bool = ...,) -> Impulse2007:
        """A copy with other values in the named fields."""

class SoftStep:
    """The fast solver (src/dynamics/soft_step.h)."""
    substeps: int
    """0: as Config::substeps says"""
    contact_frequency: float
    """Hz, at most 1/8 of the sub-steps' rate; twice as stiff against what does not move"""
    contact_damping: float
    """ratio ζ"""
    push_speed: float
    """overlap is undone no faster, m/s · length_unit"""
    carry_loads: bool
    """soft contacts do not sink under what they carry"""
    joint_frequency: float
    """Hz, of joints too many to be solved exactly; at most a quarter of the sub-steps' rate"""
    joint_damping: float
    """ratio ζ"""
    lanes: int
    """contacts solved side by side, at most; 0: as many as the processor can; changes no bit"""
    def __init__(self, *,
        substeps: int = ...,
        contact_frequency: float = ...,
        contact_damping: float = ...,
        push_speed: float = ...,
        carry_loads: bool = ...,
        joint_frequency: float = ...,
        joint_damping: float = ...,
        lanes: int = ...,) -> None: ...
    def replace(self, *,
        substeps: int = ...,
        contact_frequency: float = ...,
        contact_damping: float = ...,
        push_speed: float = ...,
        carry_loads: bool = ...,
        joint_frequency: float = ...,
        joint_damping: float = ...,
        lanes: int = ...,) -> SoftStep:
        """A copy with other values in the named fields."""

class Config:
    solver: Literal["impulse_2007", "soft_step"]
    broad: Literal["brute", "grid", "sweep", "kinetic_sweep", "tree"]
    integrator: Literal["symplectic_euler", "rk4"]
    dt: float
    """s, of World::step()"""
    substeps: int
    workers: int
    """threads that share a step, the caller's included; changes no bit of the results"""
    sleep: bool
    """quiet islands that touch or hang on something stop being computed"""
    length_unit: float
    """how many units of length a metre has: 1000 for a scene in millimetres"""
    time_factor: float
    """k of thesis (3.4): simulated seconds per second of step"""
    friction_mix: Literal["min", "geometric", "average", "max"]
    restitution_mix: Literal["min", "geometric", "average", "max"]
    impulse_2007: Impulse2007
    soft_step: SoftStep
    def __init__(self, *,
        solver: Literal["impulse_2007", "soft_step"] = ...,
        broad: Literal["brute", "grid", "sweep", "kinetic_sweep", "tree"] = ...,
        integrator: Literal["symplectic_euler", "rk4"] = ...,
        dt: float = ...,
        substeps: int = ...,
        workers: int = ...,
        sleep: bool = ...,
        length_unit: float = ...,
        time_factor: float = ...,
        friction_mix: Literal["min", "geometric", "average", "max"] = ...,
        restitution_mix: Literal["min", "geometric", "average", "max"] = ...,
        impulse_2007: Union[Impulse2007, Dict[str, Any]] = ...,
        soft_step: Union[SoftStep, Dict[str, Any]] = ...,) -> None: ...
    def replace(self, *,
        solver: Literal["impulse_2007", "soft_step"] = ...,
        broad: Literal["brute", "grid", "sweep", "kinetic_sweep", "tree"] = ...,
        integrator: Literal["symplectic_euler", "rk4"] = ...,
        dt: float = ...,
        substeps: int = ...,
        workers: int = ...,
        sleep: bool = ...,
        length_unit: float = ...,
        time_factor: float = ...,
        friction_mix: Literal["min", "geometric", "average", "max"] = ...,
        restitution_mix: Literal["min", "geometric", "average", "max"] = ...,
        impulse_2007: Union[Impulse2007, Dict[str, Any]] = ...,
        soft_step: Union[SoftStep, Dict[str, Any]] = ...,) -> Config:
        """A copy with other values in the named fields."""

class World:
    """Bodies, joints and forces that move in steps. Takes the fields of Config by name, or a Config."""
    @overload
    def __init__(self, config: Config) -> None: ...
    @overload
    def __init__(self, *,
        solver: Literal["impulse_2007", "soft_step"] = ...,
        broad: Literal["brute", "grid", "sweep", "kinetic_sweep", "tree"] = ...,
        integrator: Literal["symplectic_euler", "rk4"] = ...,
        dt: float = ...,
        substeps: int = ...,
        workers: int = ...,
        sleep: bool = ...,
        length_unit: float = ...,
        time_factor: float = ...,
        friction_mix: Literal["min", "geometric", "average", "max"] = ...,
        restitution_mix: Literal["min", "geometric", "average", "max"] = ...,
        impulse_2007: Union[Impulse2007, Dict[str, Any]] = ...,
        soft_step: Union[SoftStep, Dict[str, Any]] = ...,) -> None: ...
    @overload
    def add(self, body: BodyDef) -> Body: ...
    @overload
    def add(self, force: Union[Gravity, Drag, NBody, Thruster]) -> ForceId: ...
    @overload
    def add(self, sensor: Sensor) -> SensorId: ...
    @overload
    def add(self, *,
        shape: Shape = ...,
        shapes: Sequence[Union[ShapeDef, Dict[str, Any]]] = ...,
        at: Numbers = ...,
        turn: Numbers = ...,
        velocity: Numbers = ...,
        spin: Numbers = ...,
        density: float = ...,
        mass: float = ...,
        center: Optional[Numbers] = ...,
        inertia: Optional[NumberRows] = ...,
        material: Union[Material, Dict[str, Any]] = ...,
        surface_velocity: Numbers = ...,
        filter: Union[Filter, Dict[str, Any]] = ...,
        motion: Literal["dynamic", "kinematic", "fixed"] = ...,
        gravity_factor: float = ...,
        sleeps: bool = ...,
        name: str = ...,) -> Body:
        """Adds a body, given by the fields of BodyDef by name."""
    def join(self, joint: Union[Bar, Rope, Ball, Hinge, Slider, Fixed, Plane, Muscle, Pulley, Reel, Orientation, Azimuth, Tilt, Stroke]) -> Joint:
        """Adds a joint."""
    def remove(self, handle: Union[Body, ShapeId, Joint, ForceId, SensorId]) -> None:
        """A body takes its joints, forces and sensors with it."""
    def configure(self, *,
        solver: Literal["impulse_2007", "soft_step"] = ...,
        broad: Literal["brute", "grid", "sweep", "kinetic_sweep", "tree"] = ...,
        integrator: Literal["symplectic_euler", "rk4"] = ...,
        dt: float = ...,
        substeps: int = ...,
        workers: int = ...,
        sleep: bool = ...,
        length_unit: float = ...,
        time_factor: float = ...,
        friction_mix: Literal["min", "geometric", "average", "max"] = ...,
        restitution_mix: Literal["min", "geometric", "average", "max"] = ...,
        impulse_2007: Union[Impulse2007, Dict[str, Any]] = ...,
        soft_step: Union[SoftStep, Dict[str, Any]] = ...,) -> None:
        """Changes the named fields of the configuration."""
    def set_pair_material(self, a: Body, b: Body, material: Optional[Union[Material, Dict[str, Any]]]) -> None:
        """What holds where the two touch, instead of the mix of their materials; None: the mix again."""
    def step(self, steps: int = ..., *, dt: Optional[float] = ...) -> None:
        """Goes on by that many steps of dt [s]; None: of config.dt. Other threads run meanwhile."""
    @property
    def config(self) -> Config:
        """the settings: a copy, which may be changed and set"""
    @config.setter
    def config(self, value: Union[Config, Dict[str, Any]]) -> None: ...
    @property
    def time(self) -> float:
        """simulated, s"""
    @property
    def steps(self) -> int:
        """made so far"""
    @property
    def bodies(self) -> List[Body]: ...
    @property
    def joints(self) -> List[Joint]: ...
    @property
    def forces(self) -> List[ForceId]: ...
    @property
    def sensors(self) -> List[SensorId]: ...
    @overload
    def __getitem__(self, name: str) -> Body:
        """The first body of that name; KeyError: there is none."""
    @overload
    def __getitem__(self, body: Body) -> Body:
        """The same handle in this world: of one that was loaded from what the other saved."""
    @overload
    def __getitem__(self, joint: Joint) -> Joint: ...
    @property
    def events(self) -> Events:
        """what the last step reported"""
    @property
    def contacts(self) -> List[Contact]:
        """all touching pairs"""
    def pair_material(self, a: Body, b: Body) -> Material:
        """What holds where the two touch: set, or mixed."""
    def ray_cast(self, origin: Numbers, direction: Numbers, length: float = ..., *, filter: Optional[Union[Filter, Dict[str, Any]]] = ..., from_inside: bool = ...) -> Optional[RayHit]:
        """The nearest body on the way; direction is a unit vector, length is in m. A ray that starts in a body does not see it, unless from_inside."""
    def ray_cast_all(self, origin: Numbers, direction: Numbers, length: float = ..., *, filter: Optional[Union[Filter, Dict[str, Any]]] = ..., from_inside: bool = ...) -> List[RayHit]:
        """Every body on the way, nearest first."""
    @property
    def islands(self) -> List[int]:
        """for each body the smallest index among those that it hangs together with"""
    @property
    def energy(self) -> Energy: ...
    @property
    def momentum(self) -> Momentum: ...
    @property
    def quality(self) -> Quality: ...
    @property
    def profile(self) -> dict:
        """what the last step cost: µs a stage, counts"""
    def save(self) -> bytes:
        """Everything; a world that loads it goes on with the same bits."""
    def load(self, data: Union[bytes, str, PathLike[str]]) -> None:
        """Replaces everything by what save() returned, or by a file of that."""
    def copy(self) -> World:
        """A world of its own in the same state, in which the handles of this one are good."""
    def __copy__(self) -> World: ...
    def __deepcopy__(self, __arg0: dict) -> World: ...
    def hash(self) -> int:
        """Of everything that can change a later bit."""
    def motion_hash(self) -> int:
        """Of the poses and velocities of all bodies."""
    def __getstate__(self) -> bytes: ...
    def __setstate__(self, __arg0: bytes) -> None: ...
    def __repr__(self) -> str: ...
    @property
    def positions(self) -> Array:
        """(bodies, 3), of the shapes' frames, m, in the order of `bodies`"""
    @property
    def orientations(self) -> Array:
        """(bodies, 4): x, y, z, w"""
    @property
    def velocities(self) -> Array:
        """(bodies, 3), of the centres of mass, m/s"""
    @property
    def spins(self) -> Array:
        """(bodies, 3), rad/s"""
    def arrays(self) -> BodyArrays:
        """The four as arrays that stay where they are: update() fills them again, and what numpy made of them sees it."""

def difference(a: World, b: World) -> Optional[Difference]:
    """The first field in which two worlds differ; None: they go on with the same bits."""

class BodyArrays:
    """The state of all bodies of a world, in the order of World.bodies, as of the last update()."""
    def update(self) -> None:
        """Reads the world again. With more or fewer bodies than before the arrays are new ones."""
    @property
    def positions(self) -> Array:
        """(bodies, 3), m"""
    @property
    def orientations(self) -> Array:
        """(bodies, 4): x, y, z, w"""
    @property
    def velocities(self) -> Array:
        """(bodies, 3), m/s"""
    @property
    def spins(self) -> Array:
        """(bodies, 3), rad/s"""

class WorldBatch:
    """Copies of a world, stepped side by side by several threads: each has the bits that it has alone. Handles of the first world are good in all of them. Arrays have the worlds as their first axis; what is set may also be one row for all."""
    def __init__(self, world: World, count: int, threads: int = ...) -> None: ...
    def __len__(self) -> int: ...
    def __getitem__(self, index: int) -> World: ...
    def __iter__(self) -> Iterator[World]: ...
    @property
    def threads(self) -> int: ...
    def step(self, steps: int = ...) -> None:
        """Every world by that many steps of its config.dt. Other threads of Python run meanwhile."""
    def reset(self, which: Optional[List[int]] = ...) -> None:
        """Takes those worlds, or all, back to the state in which the batch was made."""
    @property
    def positions(self) -> Array:
        """(worlds, bodies, 3), of the shapes' frames, m"""
    @property
    def orientations(self) -> Array:
        """(worlds, bodies, 4): x, y, z, w"""
    @property
    def velocities(self) -> Array:
        """(worlds, bodies, 3), of the centres of mass, m/s"""
    @property
    def spins(self) -> Array:
        """(worlds, bodies, 3), rad/s"""
    def coordinates(self, joints: List[Joint]) -> Array:
        """(worlds, joints): angles [rad] and ways [m], as Joint.coordinate."""
    def push(self, body: Body, forces: Union[float, Numbers, NumberRows]) -> None:
        """(worlds, 3): N, at the centre of mass, during the next step only."""
    def twist(self, body: Body, torques: Union[float, Numbers, NumberRows]) -> None:
        """(worlds, 3): N·m, world axes, during the next step only."""
    def set_velocities(self, body: Body, velocities: Union[float, Numbers, NumberRows]) -> None:
        """(worlds, 3): m/s."""
    def set_spins(self, body: Body, spins: Union[float, Numbers, NumberRows]) -> None:
        """(worlds, 3): rad/s."""
    def set_positions(self, body: Body, positions: Union[float, Numbers, NumberRows]) -> None:
        """(worlds, 3): m."""
    def set_orientations(self, body: Body, orientations: Union[float, Numbers, NumberRows]) -> None:
        """(worlds, 4): unit quaternions x, y, z, w."""
    def set_targets(self, joint: Joint, targets: Union[float, Numbers, NumberRows]) -> None:
        """(worlds,): of the joint's drive, in the unit of its mode."""

class Recording:
    """Of all that is done to a world, from here to stop(); a context manager, which stops at its end. `sudar replay` plays its file."""
    def __init__(self, world: World, title: str = ...) -> None: ...
    def stop(self) -> None: ...
    def __enter__(self) -> Recording: ...
    def __exit__(self, *args) -> None: ...
    def __bytes__(self) -> bytes: ...
    def save(self, path: Union[str, PathLike[str]]) -> None:
        """Writes the recording so far."""

class Replay:
    """A recording, played step by step: iterate over it. Each step gives None, or where it differs from what was recorded."""
    def __init__(self, recording: Union[bytes, str, PathLike[str]], workers: int = ...) -> None:
        """From bytes or a path."""
    @property
    def world(self) -> World: ...
    @property
    def title(self) -> str: ...
    @property
    def cut_off(self) -> bool:
        """it has no end: these are the whole steps that there are"""
    @property
    def done(self) -> bool: ...
    def __len__(self) -> int: ...
    def step(self, check: bool = ...) -> Optional[Divergence]:
        """Plays the next step."""
    def __iter__(self) -> Replay: ...
    def __next__(self) -> Optional[Divergence]: ...

def scenarios() -> List[ScenarioInfo]:
    """All that there are, in the order of the program's browser."""

class Session:
    """A scenario being run: Session("wall", ball=0), or a file: Session("robot.glb"). Parameters of the scenario by name; what differs from its own configuration in `config`, a dict of fields of Config; `seconds` to simulate, None: the scenario's own."""
    def __init__(self, scenario: str, config: dict = ..., seconds: Optional[float] = ..., **parameters: float) -> None: ...
    @staticmethod
    def load(data: Union[bytes, str, PathLike[str]]) -> Session:
        """Goes on where save() was called; from bytes or a path."""
    def save(self) -> bytes: ...
    def step(self, steps: int = ...) -> None:
        """Steps, with what the scenario does and watches."""
    def run(self) -> List[Check]:
        """To the end; returns the verdicts."""
    @property
    def world(self) -> World: ...
    @property
    def name(self) -> str: ...
    @property
    def seconds(self) -> float:
        """at which it ends, simulated"""
    @property
    def done(self) -> bool: ...
    @property
    def parameters(self) -> List[Parameter]: ...
    @property
    def checks(self) -> List[Check]:
        """the verdicts so far; those at the end come with run()"""
    @property
    def passed(self) -> bool:
        """every verdict there is, is good, and there is at least one"""
    def hold(self, keys: List[str]) -> None:
        """The keys that are held from now on, by name: "up", "left", "space", "a"…"""
