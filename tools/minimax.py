#!/usr/bin/env python3
"""The polynomials of src/math/trig.h: minimax by the exchange algorithm of Remez (1934), in 60 decimal digits.

    tools/minimax.py            prints the coefficients, lowest power first, and the largest relative error of each

Each approximates a remainder g(z), z = x^2, so that the leading terms of the series stay exact:
    sin x = x + x z g(z)        cos x = 1 - z/2 + z^2 g(z)        atan x = x + x z g(z)
"""
from decimal import Decimal as D, getcontext

getcontext().prec = 60
PI = D("3.14159265358979323846264338327950288419716939937510582097494459")


def series(term, z):
    """The sum over k of term(k) z^k."""
    total, power, k = D(0), D(1), 0
    while True:
        step = term(k) * power
        total += step
        if abs(step) < D(10) ** -58:
            return total
        power *= z
        k += 1


def factorial(n):
    result = D(1)
    for i in range(2, n + 1):
        result *= i
    return result


def sin_rest(z):
    return series(lambda k: (-1) ** (k + 1) / factorial(2 * k + 3), z)


def cos_rest(z):
    return series(lambda k: (-1) ** k / factorial(2 * k + 4), z)


def atan_rest(z):
    return series(lambda k: D((-1) ** (k + 1)) / (2 * k + 3), z)


def solve(rows, right):
    """Gaussian elimination with row exchange."""
    n = len(rows)
    m = [list(r) + [b] for r, b in zip(rows, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(m[r][i]))
        m[i], m[pivot] = m[pivot], m[i]
        for r in range(n):
            if r != i:
                f = m[r][i] / m[i][i]
                m[r] = [a - f * b for a, b in zip(m[r], m[i])]
    return [m[i][n] / m[i][i] for i in range(n)]


def evaluate(coefficients, z):
    total = D(0)
    for c in reversed(coefficients):
        total = total * z + c
    return total


def remez(g, weight, high, count):
    """`count` coefficients of the polynomial p on [0, high] that makes max |weight (p - g)| smallest, and that maximum."""
    import math
    grid = [high * (1 - D(math.cos(math.pi * i / 400))) / 2 for i in range(1, 401)]
    values = [(z, g(z), weight(z)) for z in grid]
    picks = [values[(i + 1) * 399 // (count + 1)] for i in range(count + 1)]
    for _ in range(12):
        rows = [[z ** k for k in range(count)] + [(-1) ** i / w] for i, (z, _, w) in enumerate(picks)]
        coefficients = solve(rows, [v for _, v, _ in picks])[:count]
        errors = [(w * (evaluate(coefficients, z) - v), (z, v, w)) for z, v, w in values]
        extrema = []
        for e in errors:  # the largest error of each run of one sign
            if extrema and (extrema[-1][0] > 0) == (e[0] > 0):
                if abs(e[0]) > abs(extrema[-1][0]):
                    extrema[-1] = e
            else:
                extrema.append(e)
        while len(extrema) > count + 1:
            extrema.pop(0 if abs(extrema[0][0]) < abs(extrema[-1][0]) else -1)
        if len(extrema) <= count or [e[1] for e in extrema] == picks:
            break
        picks = [e[1] for e in extrema]
    return coefficients, max(abs(e[0]) for e in errors)


def main():
    quarter = (PI / 4) ** 2
    eighth = (D(2).sqrt() - 1) ** 2  # tan(pi/8)^2
    cases = [("sin", sin_rest, lambda z: z, quarter, 3, 6), ("cos", cos_rest, lambda z: z * z, quarter, 3, 6),
             ("atan", atan_rest, lambda z: z, eighth, 5, 11)]
    for name, g, weight, high, single, double in cases:
        for precision, count in (("float", single), ("double", double)):
            coefficients, error = remez(g, weight, high, count)
            print(f"{name} {precision}: relative error 2^{float(error.ln() / D(2).ln()):.1f}")
            for c in coefficients:
                print(f"    {float(c)!r}" if precision == "double" else f"    {float(c):.9g}f")


if __name__ == "__main__":
    main()
