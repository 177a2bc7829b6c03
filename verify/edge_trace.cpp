#include <foldless/verify/edge_trace.h>

#include <foldless/predicates/rounding.h>
#include <foldless/predicates/wall.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace foldless::verification {
namespace {

using Outcome = Trace::Outcome;

/// Walls and pillars that one line may pass before it is given up: a line passes a wall twice at most, and few lines
/// pass this many walls; without J > 0 a trace could go round for ever.
constexpr int most_steps = 100000;

/// Pillars met one after the other at which the trace branches into a fan. A scan edge along several base edges of a
/// flat part meets one pillar for each of them.
constexpr int most_pillars = 64;

/// A line at a point of a face.
struct State {
    std::int32_t face;
    Walls through; ///< walls of the face on which the point lies
    double t;
    double t_error;
    double s = 0.0; ///< how far along the line, 0 to 1
    double s_error = 0.0;
};

struct Exit {
    int wall;
    Wall::Crossing at;
};

class Tracer {
public:
    Tracer(const BaseFaces& base, const Line& line, const std::vector<Foothold>& ends)
        : base_(base), line_(line), e_(line.to - line.from), ends_(ends) {}

    Trace follow_from_any(const std::vector<State>& starts) {
        bool undecided = false;
        for (const State& start : starts) {
            const std::size_t known = crossings_.size();
            const Outcome outcome = follow(start);
            if (outcome == Outcome::followed) {
                return {outcome, std::move(crossings_), end_};
            }
            undecided = undecided || outcome == Outcome::undecided;
            crossings_.resize(known);
        }
        return {undecided ? Outcome::undecided : Outcome::lost, {}, {}};
    }

private:
    Outcome follow(State state);
    Outcome advance(State& state, const Exit& exit);
    Outcome around_pillar(std::int32_t vertex, const State& state);
    [[nodiscard]] bool find_exit(const State& state, std::optional<Exit>& exit) const;
    [[nodiscard]] bool is_met(const MovingFace& face, const State& state, const Exit& candidate) const;
    [[nodiscard]] bool runs_along(const State& state, int wall) const;
    [[nodiscard]] bool is_known_harmless(const State& state, int wall) const;
    [[nodiscard]] bool meets_only_at_end(const State& state, int wall) const;
    [[nodiscard]] EdgePart rest_of_line(const State& state) const {
        return part_of_edge(line_.from, e_, {state.s, 1.0}, state.s_error);
    }
    [[nodiscard]] bool ends_in(const State& state);
    [[nodiscard]] bool is_one_lift(const State& state, double t_end, double t_end_error) const;
    [[nodiscard]] Sign passes(const MovingFace& face, const Exit& exit) const;
    [[nodiscard]] double t_error(const MovingFace& face, const Wall::Crossing& crossing) const;
    [[nodiscard]] const Foothold* end_in(std::int32_t face) const;

    const BaseFaces& base_;
    const Line& line_;
    const Vec3 e_;
    const std::vector<Foothold>& ends_;
    std::vector<WallCrossing> crossings_;
    FacePlace end_;
    int steps_ = 0;
    int pillars_ = 0;
};

const Foothold* Tracer::end_in(std::int32_t face) const {
    const auto found = std::find_if(ends_.begin(), ends_.end(), [&](const Foothold& end) { return end.face == face; });
    return found == ends_.end() ? nullptr : &*found;
}

Outcome Tracer::follow(State state) {
    while (++steps_ < most_steps) {
        std::optional<Exit> exit;
        if (!find_exit(state, exit)) {
            return Outcome::undecided;
        }
        const bool before_end = exit && exit->at.s + exit->at.error < 1.0;
        if (!before_end && ends_in(state)) {
            return Outcome::followed;
        }
        if (!exit) {
            return Outcome::lost;
        }
        const MovingFace& face = base_.face(state.face);
        const Sign sign = passes(face, *exit);
        if (sign != Sign::positive) {
            return sign == Sign::negative ? Outcome::lost : Outcome::undecided;
        }
        const double error = exit->at.error;
        const int i = (exit->wall + 1) % 3;
        if (exit->at.lambda <= error || exit->at.lambda >= 1.0 - error) {
            state = {state.face, state.through, exit->at.t, exit->at.t_error, exit->at.s, error};
            return around_pillar(face.corners[exit->at.lambda <= error ? i : (i + 1) % 3], state);
        }
        const Outcome step = advance(state, *exit);
        if (step != Outcome::followed) {
            return step;
        }
    }
    return Outcome::undecided;
}

/// Passes the wall, from the state's face to its neighbour.
Outcome Tracer::advance(State& state, const Exit& exit) {
    const MovingFace& face = base_.face(state.face);
    const std::int32_t next = face.across[exit.wall];
    if (next < 0 || within(base_.face(next).range, exit.at.t, t_error(face, exit.at)) == Sign::negative) {
        return Outcome::lost;
    }
    Vec3 alpha = Vec3::Zero();
    alpha[(exit.wall + 1) % 3] = 1.0 - exit.at.lambda;
    alpha[(exit.wall + 2) % 3] = exit.at.lambda;
    crossings_.push_back({state.face, next, alpha, exit.at.error, exit.at.t, exit.at.t_error});
    state = {next,         wall_bit(wall_across(base_, state.face, exit.wall)), exit.at.t, exit.at.t_error, exit.at.s,
             exit.at.error};
    return Outcome::followed;
}

/// Goes on in any other moving face around the pillar. The image of a kept vertex is that vertex: no line passes it.
Outcome Tracer::around_pillar(std::int32_t vertex, const State& state) {
    if (base_.is_kept(vertex)) {
        return Outcome::lost;
    }
    if (++pillars_ > most_pillars) {
        return Outcome::undecided;
    }
    std::vector<Foothold> around;
    footholds_at(base_, vertex, around);
    bool undecided = false;
    for (const Foothold& foothold : around) {
        if (foothold.face == state.face) {
            continue;
        }
        const std::size_t known = crossings_.size();
        const Vec3 alpha = Vec3::Unit(corner_of(base_.face(state.face).corners, vertex));
        crossings_.push_back({state.face, foothold.face, alpha, state.s_error, state.t, state.t_error});
        const Outcome outcome = follow({foothold.face, foothold.walls, state.t, state.t_error, state.s, state.s_error});
        if (outcome == Outcome::followed) {
            return outcome;
        }
        undecided = undecided || outcome == Outcome::undecided;
        crossings_.resize(known);
    }
    return undecided ? Outcome::undecided : Outcome::lost;
}

/// The first crossing after the state, if any; false if rounding hides it.
bool Tracer::find_exit(const State& state, std::optional<Exit>& exit) const {
    const MovingFace& face = base_.face(state.face);
    for (int k = 0; k < 3; ++k) {
        if (runs_along(state, k)) {
            continue;
        }
        const Wall::Crossings crossings = Wall(face.triangle, k).crossings(line_.from, e_, {face.range, false});
        for (int c = 0; c < crossings.count; ++c) {
            const Exit candidate{k, crossings.values[c]};
            const bool proven = std::isfinite(candidate.at.error);
            if (!proven && is_known_harmless(state, k)) {
                continue; // it leaves the wall on which it is, or never comes near
            }
            if (!proven) {
                return false;
            }
            if (is_met(face, state, candidate) && (!exit || candidate.at.s < exit->at.s)) {
                exit = candidate;
            }
        }
    }
    return true;
}

/// Whether the line is at a crossing of the wall ahead, within the range of the face.
bool Tracer::is_met(const MovingFace& face, const State& state, const Exit& candidate) const {
    const double ahead = candidate.at.s - state.s;
    const double error = candidate.at.error + state.s_error;
    const bool is_on_wall = (state.through & wall_bit(candidate.wall)) != 0;
    if (ahead < -error || (is_on_wall && ahead <= error)) {
        return false;
    }
    const Foothold* end = end_in(state.face);
    const bool ends_on_wall = end != nullptr && (end->walls & wall_bit(candidate.wall)) != 0;
    if (ends_on_wall && candidate.at.s >= 1.0 - candidate.at.error) {
        return false;
    }
    return within(face.range, candidate.at.t, t_error(face, candidate.at)) != Sign::negative;
}

/// A straight line with both ends on a wall: its two crossings are its ends, or it lies in the wall.
bool Tracer::runs_along(const State& state, int wall) const {
    const Foothold* end = end_in(state.face);
    return (state.through & wall_bit(wall)) != 0 && end != nullptr && (end->walls & wall_bit(wall)) != 0;
}

/// Whether a crossing of the wall that cannot be located is the place where the line starts or ends, or none at all.
bool Tracer::is_known_harmless(const State& state, int wall) const {
    const MovingFace& face = base_.face(state.face);
    const Wall there(face.triangle, wall);
    return (state.through & wall_bit(wall)) != 0 || meets_only_at_end(state, wall) ||
           there.misses(line_.from, e_, face.range) ||
           stays_off_wall(face.triangle, wall, rest_of_line(state), face.range);
}

/// A line that ends at a kept corner of the wall, at t = 0, and meets it nowhere else on its way there: the
/// displacement is monotone on it.
bool Tracer::meets_only_at_end(const State& state, int wall) const {
    const MovingFace& face = base_.face(state.face);
    const Foothold* end = end_in(state.face);
    const Range way{std::min(state.t, 0.0) - state.t_error, std::max(state.t, 0.0) + state.t_error};
    for (const int corner : {(wall + 1) % 3, (wall + 2) % 3}) {
        const unsigned walls_there = wall_bit(wall) | wall_bit(3 - wall - corner);
        const bool at_corner = end != nullptr && (end->walls & walls_there) == walls_there;
        if (at_corner && base_.is_kept(face.corners[corner])) {
            const Wall there(face.triangle, wall);
            const int lambda = corner == (wall + 1) % 3 ? 0 : 1;
            return there.met_only_at_corner(e_, lambda, way) || there.passes(e_, way) != Sign::undecided;
        }
    }
    return false;
}

bool Tracer::ends_in(const State& state) {
    if (!ends_.empty()) {
        const Foothold* end = end_in(state.face);
        return end != nullptr && is_one_lift(state, end->t, end->t_error);
    }
    const std::optional<FacePlace> place = place_in(base_, state.face, line_.to, line_.error);
    if (place) {
        end_ = *place;
    }
    return place && is_one_lift(state, place->at.t, place->at.t_error);
}

/// Whether t goes from the state to the end as dt/ds = w/J says, w(t) = N(t).e, at both. Where it does not, the lift of
/// the line leaves the prismoid through its roof and another one comes in through its floor.
bool Tracer::is_one_lift(const State& state, double t_end, double t_end_error) const {
    const double rise = t_end - state.t;
    if (std::abs(rise) <= state.t_error + t_end_error) {
        return true;
    }
    const BaseTriangle& triangle = base_.face(state.face).triangle;
    const auto falls_against = [&](double t) {
        const Vec3 e1 = (triangle.v[1] - triangle.v[0]) + t * (triangle.d[1] - triangle.d[0]);
        const Vec3 e2 = (triangle.v[2] - triangle.v[0]) + t * (triangle.d[2] - triangle.d[0]);
        // Four roundings in e1 and e2, four in the cross product, three in the dot product.
        const double error = 30 * unit_roundoff * 2 * sum_norm(e_) * sum_norm(e1) * sum_norm(e2);
        return sign_within(std::copysign(1.0, rise) * e1.cross(e2).dot(e_), error) == Sign::negative;
    };
    return !falls_against(state.t) && !falls_against(t_end);
}

double Tracer::t_error(const MovingFace& face, const Wall::Crossing& crossing) const {
    if (line_.error == 0.0) {
        return crossing.t_error;
    }
    // The line is off by line_.error: t moves by at most that over the length of N.d / |N|, as in the inverse of DF.
    const Vec3 normal = (face.triangle.corner(1, crossing.t) - face.triangle.corner(0, crossing.t))
                            .cross(face.triangle.corner(2, crossing.t) - face.triangle.corner(0, crossing.t));
    double slope = std::abs(normal.dot(face.triangle.d[0]));
    for (const Vec3& d : face.triangle.d) {
        slope = std::min(slope, std::abs(normal.dot(d)));
    }
    return crossing.t_error + line_.error * sum_norm(normal) / slope;
}

/// The sign of e.((a_j - a_i)(t) x d(lambda)): positive where the line passes outwards.
Sign Tracer::passes(const MovingFace& face, const Exit& exit) const {
    const int i = (exit.wall + 1) % 3;
    const int j = (exit.wall + 2) % 3;
    const Vec3 turn = face.triangle.d[j] - face.triangle.d[i];
    const Vec3 r = (face.triangle.v[j] - face.triangle.v[i]) + exit.at.t * turn;
    const Vec3 d = face.triangle.d[i] + exit.at.lambda * turn;
    // Rounding: four in each component of r and d, four in the cross product, three in the dot product; 30 covers them
    // on twice the product of the sizes. The value is linear in lambda and in t, as turn x turn = 0, so their errors
    // move it by no more than its slopes; these are rounded, too.
    const double size_r = max_norm(face.triangle.v[j] - face.triangle.v[i]) + std::abs(exit.at.t) * max_norm(turn);
    const double size_d = max_norm(face.triangle.d[i]) + max_norm(turn);
    const double moved_r = max_norm(turn) * exit.at.t_error;
    const double moved_d = max_norm(turn) * exit.at.error;
    const double rounding = 2 * sum_norm(e_) * 30 * unit_roundoff * (size_r + moved_r) * (size_d + moved_d);
    const double moved =
        std::abs(e_.dot(r.cross(turn))) * exit.at.error + std::abs(e_.dot(turn.cross(d))) * exit.at.t_error;
    const double error = 2 * rounding + 1.01 * moved;
    return sign_within(e_.dot(r.cross(d)), error);
}

} // namespace

Trace trace(const BaseFaces& base, const Line& line, const std::vector<Foothold>& starts,
            const std::vector<Foothold>& ends) {
    std::vector<State> states;
    states.reserve(starts.size());
    const auto is_end = [&](std::int32_t face) {
        return std::any_of(ends.begin(), ends.end(), [&](const Foothold& end) { return end.face == face; });
    };
    for (const Foothold& start : starts) {
        states.push_back({start.face, start.walls, start.t, start.t_error});
    }
    std::stable_partition(states.begin(), states.end(), [&](const State& state) { return is_end(state.face); });
    return Tracer(base, line, ends).follow_from_any(states);
}

} // namespace foldless::verification
