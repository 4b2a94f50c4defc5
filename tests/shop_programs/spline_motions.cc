// What LinuxCNC's control makes of a spline: loaded before its module gcode, which draws points of it instead.
// Points and tangents are LinuxCNC's own; two arcs join them, with tangents of one length (a biarc).
#include <cmath>
#include <vector>
#include "canon.hh"

static void arc(int line, PLANE_POINT from, PLANE_POINT to, PLANE_POINT along) {
    const double x = to.X - from.X, y = to.Y - from.Y, across = x * along.Y - y * along.X;
    const double z = GET_EXTERNAL_POSITION_Z(), a = GET_EXTERNAL_POSITION_A(), b = GET_EXTERNAL_POSITION_B(),
                 c = GET_EXTERNAL_POSITION_C();
    if (std::fabs(across) < 5e-7) {
        STRAIGHT_FEED(line, to.X, to.Y, z, a, b, c, 0, 0, 0);
        return;
    }
    const double radius = (x * x + y * y) / (2 * across);  // to the right of the direction
    ARC_FEED(line, to.X, to.Y, from.X + radius * along.Y, from.Y - radius * along.X, radius < 0 ? 1 : -1, z, a, b, c, 0,
             0, 0);
}

void NURBS_FEED(int line, std::vector<CONTROL_POINT> points, unsigned int order) {
    const unsigned int last = points.size() - 1, pieces = 4 * points.size();
    const std::vector<unsigned int> knots = knot_vector_creator(last, order);
    const double end = last - order + 2;
    PLANE_POINT p = nurbs_point(0, order, points, knots), t = nurbs_tangent(0, order, points, knots);
    for (unsigned int piece = 1; piece <= pieces; piece++) {
        const double u = end * piece / pieces;
        const PLANE_POINT q = nurbs_point(u, order, points, knots), s = nurbs_tangent(u, order, points, knots);
        const double vx = p.X - q.X, vy = p.Y - q.Y;
        // the length that makes both arcs meet, from a square equation
        const double a = 2 * (t.X * s.X + t.Y * s.Y - 1), b = 2 * (vx * (t.X + s.X) + vy * (t.Y + s.Y)),
                     c = vx * vx + vy * vy, root = std::sqrt(b * b - 4 * a * c);
        const double size = std::fmax((-b - root) / (2 * a), (-b + root) / (2 * a));
        const PLANE_POINT first = {p.X + size * t.X, p.Y + size * t.Y}, second = {q.X - size * s.X, q.Y - size * s.Y};
        const double length = std::hypot(second.X - first.X, second.Y - first.Y);
        const PLANE_POINT middle = {(first.X + second.X) / 2, (first.Y + second.Y) / 2},
                          along = {(second.X - first.X) / length, (second.Y - first.Y) / length};
        arc(line, p, middle, t);
        arc(line, middle, q, along);
        p = q;
        t = s;
    }
}
