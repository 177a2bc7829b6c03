#include "surface_oracle.h"

#include "exact_root.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace foldless::oracle {
namespace {

// --- Vectors of numbers and of polynomials ---------------------------------------------------------------------------

template <class T>
using Vector = std::array<T, 3>;

template <class T>
Vector<T> operator-(const Vector<T>& a, const Vector<T>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

using Point = Vector<Number>;
using Curve = Vector<Polynomial>; ///< each coordinate a polynomial

Point exact(const Vec3& p) {
    return {Number(p.x()), Number(p.y()), Number(p.z())};
}

Polynomial constant(const Number& x) {
    return Polynomial({x});
}

Curve constant(const Point& p) {
    return {constant(p[0]), constant(p[1]), constant(p[2])};
}

/// a + x b
Polynomial line(const Number& a, const Number& b) {
    return Polynomial({a, b});
}

Curve line(const Point& a, const Point& b) {
    return {line(a[0], b[0]), line(a[1], b[1]), line(a[2], b[2])};
}

int sign(const Number& x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

struct Refused {
    std::string reason;
};
struct Tie {
    std::string reason;
};

struct ExactBox {
    Point lo;
    Point hi;

    explicit ExactBox(const std::vector<Point>& points) : lo(points[0]), hi(points[0]) {
        for (const Point& p : points) {
            for (int k = 0; k < 3; ++k) {
                lo[k] = std::min(lo[k], p[k]);
                hi[k] = std::max(hi[k], p[k]);
            }
        }
    }
    [[nodiscard]] bool meets(const ExactBox& other) const {
        for (int k = 0; k < 3; ++k) {
            if (hi[k] < other.lo[k] || other.hi[k] < lo[k]) {
                return false;
            }
        }
        return true;
    }
};

// --- The meshes ------------------------------------------------------------------------------------------------------

using Edge = std::pair<int, int>; ///< lower end first

Edge edge_of(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

struct Prismoid {
    int face;
    Triangle corners;
    Number lo, hi;
    std::array<Curve, 3> a; ///< corners of the slice
    Curve normal;           ///< of the slice
    ExactBox box;
};

struct BaseEdge {
    int i, j;               ///< i < j
    std::vector<int> faces; ///< moving ones
    bool is_scan_edge = false;
    ExactBox box; ///< around its walls
};

struct Place {
    int face; ///< one of them if kept
    Root t;
    int kept = -1; ///< base vertex
};

/// Two walls' roots are one if the base edge and the number among the roots of their quadratic agree.
struct WallNode {
    Edge base_edge;
    int root;
    auto operator<=>(const WallNode&) const = default;
};

struct Lift {
    int from; ///< index of the place of the lower end
    int to;
    std::set<WallNode> crossed;
    std::set<WallNode> touched;
    std::array<bool, 2> seen_from_front{true, true}; ///< m > 0 all along, for each of the two scan faces
};

struct EdgeLifts {
    std::vector<Lift> lifts;
    std::map<Edge, std::vector<Root>> wall_roots; ///< the displacements at which the line meets each wall
};

class Oracle {
public:
    Oracle(const BaseMesh& base, const Scan& scan) : base_(base), scan_(scan) {}

    void judge() {
        read_kept();
        read_faces();
        check_borders();
        prepare_prismoids();
        prepare_base_edges();
        check_kept_windings();
        find_places();
        choose_places();
    }

private:
    void read_kept();
    void read_faces();
    void check_borders() const;
    void prepare_prismoids();
    void prepare_base_edges();
    void check_kept_windings() const;
    void find_places();
    [[nodiscard]] std::vector<Place> places_of(int vertex) const;
    void choose_places();
    [[nodiscard]] std::vector<std::vector<int>> scan_parts() const;
    [[nodiscard]] std::optional<std::map<int, int>> section(const std::vector<int>& part, int place);
    void check(const std::map<int, int>& chosen);
    void check_only_place(const std::map<int, int>& chosen) const;
    void check_corners(const std::map<int, int>& chosen);
    const EdgeLifts& lifts(int a, int b);
    [[nodiscard]] EdgeLifts find_lifts(int a, int b);
    [[nodiscard]] bool is_fixed(int a, int b) const;
    [[nodiscard]] Point normal_of(int scan_face) const;
    [[nodiscard]] std::array<int, 2> faces_at(int a, int b) const;
    [[nodiscard]] std::set<int> fan_under(int scan_face, int kept) const;
    void tile(const std::map<int, int>& chosen);

    friend class EdgeLifter;
    friend class Tiling;

    const BaseMesh& base_;
    const Scan& scan_;
    std::vector<int> base_of_; ///< per scan vertex
    std::vector<int> scan_of_; ///< per base vertex
    std::map<Edge, int> base_side_;
    std::map<Edge, int> scan_side_;
    std::vector<bool> frozen_base_;
    std::vector<bool> frozen_scan_;
    std::vector<Point> v_, d_, q_;
    std::vector<Prismoid> prismoids_;
    std::vector<int> prismoid_of_; ///< per base face, or -1
    std::map<Edge, BaseEdge> base_edges_;
    std::vector<std::vector<Place>> places_;
    std::map<Edge, EdgeLifts> lifts_;
};

void Oracle::read_kept() {
    base_of_.assign(scan_.positions.size(), -1);
    scan_of_.assign(base_.positions.size(), -1);
    for (std::size_t b = 0; b < base_.scan_vertex.size(); ++b) {
        const int s = base_.scan_vertex[b];
        if (s == -1) {
            continue;
        }
        if (s < 0 || s >= static_cast<int>(scan_.positions.size()) || base_.positions[b] != scan_.positions[s] ||
            base_of_[s] >= 0) {
            throw Refused{"kept vertex"};
        }
        base_of_[s] = static_cast<int>(b);
        scan_of_[b] = s;
    }
    for (const Vec3& p : base_.positions) {
        v_.push_back(exact(p));
    }
    for (const Vec3& p : base_.directions) {
        d_.push_back(exact(p));
    }
    for (const Vec3& p : scan_.positions) {
        q_.push_back(exact(p));
    }
}

void Oracle::read_faces() {
    const auto sides = [](const std::vector<Triangle>& faces, std::map<Edge, int>& side) {
        for (std::size_t f = 0; f < faces.size(); ++f) {
            for (int k = 0; k < 3; ++k) {
                side[{faces[f][k], faces[f][(k + 1) % 3]}] = static_cast<int>(f);
            }
        }
    };
    sides(base_.faces, base_side_);
    sides(scan_.faces, scan_side_);
    frozen_base_.assign(base_.faces.size(), false);
    frozen_scan_.assign(scan_.faces.size(), false);
    for (std::size_t f = 0; f < base_.faces.size(); ++f) {
        std::array<int, 3> scan_corners{};
        for (int k = 0; k < 3; ++k) {
            scan_corners[k] = scan_of_[base_.faces[f][k]];
        }
        const auto same = scan_side_.find({scan_corners[0], scan_corners[1]});
        const bool is_still = base_.ranges[f].lo == 0 && base_.ranges[f].hi == 0;
        if (is_still && same != scan_side_.end()) {
            const Triangle& face = scan_.faces[same->second];
            if (std::find(face.begin(), face.end(), scan_corners[2]) != face.end()) {
                frozen_base_[f] = true;
                frozen_scan_[same->second] = true;
            }
        }
    }
}

/// Every border edge of one mesh is one of the other, and moving faces lie on the same sides of edges that both have.
void Oracle::check_borders() const {
    for (const auto& [side, face] : base_side_) {
        const bool is_border = !base_side_.contains({side.second, side.first});
        const Edge there{scan_of_[side.first], scan_of_[side.second]};
        const auto same = scan_side_.find(there);
        if (is_border && (same == scan_side_.end() || scan_side_.contains({there.second, there.first}))) {
            throw Refused{"base border"};
        }
        const auto across = scan_side_.find({there.second, there.first});
        const bool is_edge = same != scan_side_.end() || across != scan_side_.end();
        const bool moves_there = same != scan_side_.end() && !frozen_scan_[same->second];
        if (is_edge && moves_there == frozen_base_[face]) {
            throw Refused{"seam"};
        }
    }
    for (const auto& [side, face] : scan_side_) {
        const bool is_border = !scan_side_.contains({side.second, side.first});
        const Edge there{base_of_[side.first], base_of_[side.second]};
        if (is_border && (!base_side_.contains(there) || base_side_.contains({there.second, there.first}))) {
            throw Refused{"scan border"};
        }
        const auto opposite = base_side_.find({there.second, there.first});
        const bool is_edge = base_side_.contains(there) || opposite != base_side_.end();
        if (is_edge && !base_side_.contains(there) && !frozen_scan_[face]) {
            throw Refused{"seam"};
        }
    }
}

void Oracle::prepare_prismoids() {
    prismoid_of_.assign(base_.faces.size(), -1);
    for (std::size_t f = 0; f < base_.faces.size(); ++f) {
        if (frozen_base_[f]) {
            continue;
        }
        const Range range = base_.ranges[f];
        if (!std::isfinite(range.lo) || !std::isfinite(range.hi) || !(range.lo <= range.hi)) {
            throw Refused{"range"};
        }
        const Triangle& corners = base_.faces[f];
        std::array<Curve, 3> a;
        std::vector<Point> hull;
        for (int k = 0; k < 3; ++k) {
            const Point& v = v_[corners[k]];
            const Point& d = d_[corners[k]];
            a[k] = line(v, d);
            for (const double t : {range.lo, range.hi}) {
                hull.push_back({v[0] + Number(t) * d[0], v[1] + Number(t) * d[1], v[2] + Number(t) * d[2]});
            }
        }
        Prismoid prismoid{static_cast<int>(f), corners, Number(range.lo),
                          Number(range.hi),    a,       cross(a[1] - a[0], a[2] - a[0]),
                          ExactBox(hull)};
        for (int k = 0; k < 3; ++k) {
            const Polynomial jacobian = dot(prismoid.normal, constant(d_[corners[k]]));
            if (jacobian.sign_at(prismoid.lo) <= 0 || !roots(jacobian, prismoid.lo, prismoid.hi).empty()) {
                throw Refused{"jacobian"};
            }
        }
        prismoid_of_[f] = static_cast<int>(prismoids_.size());
        prismoids_.push_back(std::move(prismoid));
    }
}

void Oracle::prepare_base_edges() {
    for (const Prismoid& prismoid : prismoids_) {
        for (int k = 0; k < 3; ++k) {
            const Edge edge = edge_of(prismoid.corners[k], prismoid.corners[(k + 1) % 3]);
            std::vector<Point> hull;
            for (const int corner : {k, (k + 1) % 3}) {
                for (const Number& t : {prismoid.lo, prismoid.hi}) {
                    const auto& a = prismoid.a[corner];
                    hull.push_back({a[0].at(t), a[1].at(t), a[2].at(t)});
                }
            }
            BaseEdge& entry =
                base_edges_.try_emplace(edge, BaseEdge{edge.first, edge.second, {}, false, ExactBox(hull)})
                    .first->second;
            entry.faces.push_back(prismoid.face);
            const int a = scan_of_[edge.first];
            const int b = scan_of_[edge.second];
            entry.is_scan_edge = a >= 0 && b >= 0 && (scan_side_.contains({a, b}) || scan_side_.contains({b, a}));
        }
    }
    for (const auto& [edge, entry] : base_edges_) {
        if (!entry.is_scan_edge && entry.faces.size() != 2) {
            throw Refused{"open base edge"};
        }
    }
}

/// Seen along the direction of a kept vertex, no two base faces around it lie over each other at t = 0. Fans are taken
/// between frozen faces and borders.
void Oracle::check_kept_windings() const {
    for (std::size_t i = 0; i < v_.size(); ++i) {
        if (scan_of_[i] < 0) {
            continue;
        }
        std::map<int, int> next; // from one spoke to the next one counter-clockwise
        for (const Prismoid& prismoid : prismoids_) {
            for (int k = 0; k < 3; ++k) {
                if (prismoid.corners[k] == static_cast<int>(i)) {
                    next[prismoid.corners[(k + 1) % 3]] = prismoid.corners[(k + 2) % 3];
                }
            }
        }
        const auto turn = [&](int j, int k) { return sign(dot(d_[i], cross(v_[j] - v_[i], v_[k] - v_[i]))); };
        std::set<int> left; // spokes that begin a sector
        for (const auto& [from, to] : next) {
            left.insert(from);
        }
        while (!left.empty()) {
            int first = *left.begin();
            for (const auto& [from, to] : next) { // the beginning of an open fan has no spoke before it
                const bool has_before =
                    std::any_of(next.begin(), next.end(), [&, f = from](const auto& s) { return s.second == f; });
                if (left.contains(from) && !has_before) {
                    first = from;
                }
            }
            std::vector<std::pair<int, int>> fan;
            for (int spoke = first; left.contains(spoke); spoke = next.at(spoke)) {
                left.erase(spoke);
                fan.emplace_back(spoke, next.at(spoke));
            }
            for (const auto& [spoke, unused] : fan) {
                for (const auto& [a, b] : fan) {
                    const bool holds = a != spoke && b != spoke && turn(a, spoke) >= 0 && turn(spoke, b) > 0;
                    if (holds) {
                        throw Refused{"base winding"};
                    }
                }
            }
        }
    }
}

bool Oracle::is_fixed(int a, int b) const {
    const int i = base_of_[a];
    const int j = base_of_[b];
    return i >= 0 && j >= 0 && (base_side_.contains({i, j}) || base_side_.contains({j, i}));
}

Point Oracle::normal_of(int scan_face) const {
    const Triangle& face = scan_.faces[scan_face];
    return cross(q_[face[1]] - q_[face[0]], q_[face[2]] - q_[face[0]]);
}

/// The scan faces left and right of the edge; -1 if absent or frozen.
std::array<int, 2> Oracle::faces_at(int a, int b) const {
    std::array<int, 2> result{-1, -1};
    const auto left = scan_side_.find({a, b});
    const auto right = scan_side_.find({b, a});
    if (left != scan_side_.end() && !frozen_scan_[left->second]) {
        result[0] = left->second;
    }
    if (right != scan_side_.end() && !frozen_scan_[right->second]) {
        result[1] = right->second;
    }
    return result;
}

/// The moving base faces around a kept vertex, given as a base vertex, between the frozen faces or borders between
/// which the scan face lies. Another fan may lie in front of or behind them.
std::set<int> Oracle::fan_under(int scan_face, int kept) const {
    const auto after = [](const Triangle& face, int vertex) {
        return face[(std::find(face.begin(), face.end(), vertex) - face.begin() + 1) % 3];
    };
    const int vertex = scan_of_[kept];
    std::set<int> fan;
    int first = after(scan_.faces[scan_face], vertex);
    for (const int start = first;;) { // clockwise to the first edge of the scan's fan
        const auto before = scan_side_.find({first, vertex});
        if (before == scan_side_.end() || frozen_scan_[before->second]) {
            break;
        }
        first = after(scan_.faces[before->second], vertex);
        if (first == start) { // all around
            for (const Prismoid& prismoid : prismoids_) {
                const auto& c = prismoid.corners;
                if (std::find(c.begin(), c.end(), kept) != c.end()) {
                    fan.insert(prismoid.face);
                }
            }
            return fan;
        }
    }
    for (int spoke = base_of_[first];;) { // counter-clockwise
        const auto next = base_side_.find({kept, spoke});
        if (next == base_side_.end() || frozen_base_[next->second] || !fan.insert(next->second).second) {
            return fan;
        }
        spoke = after(base_.faces[next->second], spoke);
    }
}

// --- Places ----------------------------------------------------------------------------------------------------------

std::vector<Place> Oracle::places_of(int vertex) const {
    if (base_of_[vertex] >= 0) {
        int face = -1;
        for (const Prismoid& prismoid : prismoids_) {
            const auto& c = prismoid.corners;
            if (std::find(c.begin(), c.end(), base_of_[vertex]) != c.end()) {
                face = prismoid.face;
                if (prismoid.lo > 0 || prismoid.hi < 0) {
                    throw Refused{"kept vertex out of range"};
                }
            }
        }
        if (face < 0) {
            throw Refused{"kept vertex among frozen faces"};
        }
        return {{face, Root(Number(0)), base_of_[vertex]}};
    }
    std::vector<Place> result;
    const Point& q = q_[vertex];
    const ExactBox box({q});
    for (const Prismoid& prismoid : prismoids_) {
        if (!prismoid.box.meets(box)) {
            continue;
        }
        const auto& a = prismoid.a;
        const Curve at = constant(q);
        for (Root& t : roots(dot(prismoid.normal, a[0] - at), prismoid.lo, prismoid.hi)) {
            std::array<int, 3> alpha{};
            for (int k = 0; k < 3; ++k) {
                alpha[k] = t.sign_of(dot(prismoid.normal, cross(a[(k + 1) % 3] - at, a[(k + 2) % 3] - at)));
            }
            if (std::min({alpha[0], alpha[1], alpha[2]}) > 0) {
                result.push_back({prismoid.face, t, -1});
            } else if (std::min({alpha[0], alpha[1], alpha[2]}) == 0) {
                throw Tie{"vertex on a wall"};
            }
        }
    }
    if (result.empty()) {
        throw Refused{"no place"};
    }
    return result;
}

void Oracle::find_places() {
    places_.resize(scan_.positions.size());
    std::set<int> used;
    for (std::size_t f = 0; f < scan_.faces.size(); ++f) {
        if (!frozen_scan_[f]) {
            used.insert(scan_.faces[f].begin(), scan_.faces[f].end());
        }
    }
    std::optional<Tie> tie; // a refusal is more than a tie
    for (const int vertex : used) {
        try {
            places_[vertex] = places_of(vertex);
        } catch (const Tie& found) {
            tie = found;
        }
    }
    if (tie) {
        throw *tie;
    }
}

// --- Lifts of scan edges ---------------------------------------------------------------------------------------------

/// All pieces of the lifts of one scan edge, in all prismoids.
class EdgeLifter {
public:
    EdgeLifter(const Oracle& oracle, int a, int b)
        : o_(oracle), a_(a), b_(b), q_(o_.q_[a]), e_(o_.q_[b] - o_.q_[a]), faces_(o_.faces_at(a, b)) {}

    EdgeLifts find() {
        const ExactBox box({o_.q_[a_], o_.q_[b_]});
        for (const Prismoid& prismoid : o_.prismoids_) {
            if (prismoid.box.meets(box)) {
                find_pieces(prismoid);
            }
        }
        link();
        return std::move(result_);
    }

private:
    enum class Tag { wall, start, end, pole };
    struct Cut {
        Root t;
        Tag tag;
        int index; ///< of the node
    };
    struct Piece {
        int face;
        std::array<int, 2> ends; ///< nodes, or -1
        std::array<bool, 2> seen_from_front{true, true};
    };
    struct Node {
        Tag tag;
        int place = -1;
        WallNode wall{};
        std::vector<int> pieces;
    };

    /// The quadratic of a wall, the same from both sides: e.((a_i - q) x (a_j - q)), i < j.
    Polynomial side(const Edge& edge) const {
        const Curve at = constant(q_);
        return dot(constant(e_), cross(line(o_.v_[edge.first], o_.d_[edge.first]) - at,
                                       line(o_.v_[edge.second], o_.d_[edge.second]) - at));
    }

    /// Its roots over the ranges of both faces together: the same list for both.
    std::vector<Root>& wall_roots(const Edge& edge, const Polynomial& polynomial) {
        const auto known = result_.wall_roots.find(edge);
        if (known != result_.wall_roots.end()) {
            return known->second;
        }
        const BaseEdge& entry = o_.base_edges_.at(edge);
        Number lo = o_.prismoids_[o_.prismoid_of_[entry.faces[0]]].lo;
        Number hi = o_.prismoids_[o_.prismoid_of_[entry.faces[0]]].hi;
        for (const int face : entry.faces) {
            lo = std::min(lo, o_.prismoids_[o_.prismoid_of_[face]].lo);
            hi = std::max(hi, o_.prismoids_[o_.prismoid_of_[face]].hi);
        }
        return result_.wall_roots.emplace(edge, roots(polynomial, lo, hi)).first->second;
    }

    int node(Tag tag, int place, const WallNode& wall) {
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            if (nodes_[n].tag == tag && nodes_[n].place == place && (tag != Tag::wall || nodes_[n].wall == wall)) {
                return static_cast<int>(n);
            }
        }
        nodes_.push_back({tag, place, wall, {}});
        return static_cast<int>(nodes_.size()) - 1;
    }

    /// The node of a place of vertex a or b in this prismoid at a root of its cubic, or -1.
    int place_node(const Prismoid& prismoid, Tag tag, Root& t, bool is_only_root) {
        const int vertex = tag == Tag::start ? a_ : b_;
        const std::vector<Place>& places = o_.places_[vertex];
        for (std::size_t p = 0; p < places.size(); ++p) {
            Root of_place = places[p].t;
            const bool here =
                places[p].kept >= 0 ? is_in_fan(prismoid, tag, places[p].kept) : places[p].face == prismoid.face;
            if (here && (is_only_root || t.compare(of_place) == 0)) {
                return node(tag, static_cast<int>(p), {});
            }
        }
        return -1;
    }

    /// Whether the prismoid lies among those around the kept end into which this edge may lead. The line may begin in
    /// one of another fan, too, which frozen faces part from them.
    bool is_in_fan(const Prismoid& prismoid, Tag tag, int kept) {
        const auto& c = prismoid.corners;
        if (std::find(c.begin(), c.end(), kept) == c.end()) {
            return false;
        }
        std::optional<std::set<int>>& fan = fans_[tag == Tag::start ? 0 : 1];
        if (!fan) {
            fan = o_.fan_under(std::max(faces_[0], faces_[1]), kept);
        }
        return fan->contains(prismoid.face);
    }

    void find_pieces(const Prismoid& prismoid);
    [[nodiscard]] static int end_node(const std::vector<Cut>& at);
    void link();

    const Oracle& o_;
    int a_, b_;
    Point q_;
    Point e_;
    std::array<int, 2> faces_;
    std::array<std::optional<std::set<int>>, 2> fans_; ///< around the ends, if kept
    std::vector<Node> nodes_;
    std::vector<Piece> pieces_;
    EdgeLifts result_;
};

void EdgeLifter::find_pieces(const Prismoid& prismoid) {
    const Polynomial w = dot(prismoid.normal, constant(e_));
    const Polynomial start = dot(prismoid.normal, prismoid.a[0] - constant(q_));
    const Polynomial end = start - w;
    if (w.is_zero()) {
        if (!roots(start, prismoid.lo, prismoid.hi).empty()) {
            throw Tie{"edge in a slice"};
        }
        return;
    }
    std::vector<Cut> cuts;
    std::vector<Root> zeros = roots(w, prismoid.lo, prismoid.hi);
    for (Root& t : zeros) {
        if (t.sign_of(start) == 0) {
            throw Tie{"edge in a slice"};
        }
        cuts.push_back({t, Tag::pole, -1});
    }
    // Most prismoids are far away: one of the conditions fails all over the range.
    const auto fails = [&](const Polynomial& p, const std::vector<Root>& of_p, int wanted) {
        return zeros.empty() && of_p.empty() && p.sign_at(prismoid.lo) * w.sign_at(prismoid.lo) * wanted < 0;
    };
    std::vector<Root> starts = roots(start, prismoid.lo, prismoid.hi);
    if (fails(start, starts, 1)) {
        return;
    }
    std::vector<Root> ends = roots(end, prismoid.lo, prismoid.hi);
    if (fails(end, ends, -1)) {
        return;
    }
    std::array<Polynomial, 3> sides;
    for (int k = 0; k < 3; ++k) {
        const int i = prismoid.corners[(k + 1) % 3];
        const int j = prismoid.corners[(k + 2) % 3];
        const Edge edge = edge_of(i, j);
        const Polynomial both = side(edge);
        if (both.is_zero()) {
            throw Tie{"edge along a wall"};
        }
        sides[k] = i < j ? both : Number(-1) * both;
        std::vector<Root>& of_wall = wall_roots(edge, both);
        if (fails(sides[k], of_wall, 1)) {
            return;
        }
        for (std::size_t r = 0; r < of_wall.size(); ++r) {
            cuts.push_back({of_wall[r], Tag::wall, node(Tag::wall, -1, {edge, static_cast<int>(r)})});
        }
    }
    for (Root& t : starts) {
        cuts.push_back({t, Tag::start, place_node(prismoid, Tag::start, t, starts.size() == 1)});
    }
    for (Root& t : ends) {
        cuts.push_back({t, Tag::end, place_node(prismoid, Tag::end, t, ends.size() == 1)});
    }
    cuts.push_back({Root(prismoid.lo), Tag::pole, -1});
    cuts.push_back({Root(prismoid.hi), Tag::pole, -1});
    std::vector<std::vector<Cut>> groups; // of equal t, ascending
    for (Cut& cut : cuts) {
        auto group = groups.begin();
        int order = 1;
        for (; group != groups.end(); ++group) {
            order = group->front().t.compare(cut.t);
            if (order >= 0) {
                break;
            }
        }
        if (group != groups.end() && order == 0) {
            group->push_back(cut);
        } else {
            groups.insert(group, {cut});
        }
    }
    for (std::size_t g = 0; g + 1 < groups.size(); ++g) {
        Root& lo = groups[g].front().t;
        Root& hi = groups[g + 1].front().t;
        const Number t = between(lo, hi);
        if (t < prismoid.lo || t > prismoid.hi) {
            continue;
        }
        const int direction = w.sign_at(t);
        const bool on_edge = start.sign_at(t) * direction >= 0 && end.sign_at(t) * direction <= 0;
        const auto inside = [&](const Polynomial& p) { return p.sign_at(t) * direction >= 0; };
        if (!on_edge || !inside(sides[0]) || !inside(sides[1]) || !inside(sides[2])) {
            continue;
        }
        Piece piece{prismoid.face, {end_node(groups[g]), end_node(groups[g + 1])}};
        for (int f = 0; f < 2; ++f) {
            if (faces_[f] < 0) {
                continue;
            }
            const Point n = o_.normal_of(faces_[f]);
            Polynomial m;
            for (int k = 0; k < 3; ++k) {
                m = m + dot(n, o_.d_[prismoid.corners[k]]) * sides[k];
            }
            bool front = m.sign_at(t) * direction > 0;
            for (Root& zero : roots(m, prismoid.lo, prismoid.hi)) {
                front = front && (zero.compare(lo) < 0 || zero.compare(hi) > 0);
            }
            piece.seen_from_front[f] = front;
        }
        for (const int n : piece.ends) {
            if (n >= 0) {
                nodes_[n].pieces.push_back(static_cast<int>(pieces_.size()));
            }
        }
        pieces_.push_back(piece);
    }
}

/// The node at the end of a piece: the place of an end of the edge before any wall that it lies on, as a kept vertex
/// does.
int EdgeLifter::end_node(const std::vector<Cut>& at) {
    int wall = -1;
    int walls = 0;
    for (const Cut& cut : at) {
        if (cut.tag == Tag::start || cut.tag == Tag::end) {
            return cut.index;
        }
        if (cut.tag == Tag::wall) {
            wall = cut.index;
            ++walls;
        }
    }
    if (walls > 1) {
        throw Tie{"edge through a pillar"};
    }
    return wall;
}

void EdgeLifter::link() {
    // Parts of the graph, by joining the nodes of each piece.
    std::vector<int> part(pieces_.size());
    std::iota(part.begin(), part.end(), 0);
    bool goes_on = true;
    while (goes_on) {
        goes_on = false;
        for (const Node& here : nodes_) {
            int lowest = static_cast<int>(pieces_.size());
            for (const int p : here.pieces) {
                lowest = std::min(lowest, part[p]);
            }
            for (const int p : here.pieces) {
                goes_on = goes_on || part[p] != lowest;
                part[p] = lowest;
            }
        }
    }
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        if (part[p] != static_cast<int>(p)) {
            continue;
        }
        Lift lift{-1, -1, {}, {}};
        bool is_path = true;
        std::set<int> at;
        for (std::size_t other = p; other < pieces_.size(); ++other) {
            if (part[other] != static_cast<int>(p)) {
                continue;
            }
            for (int f = 0; f < 2; ++f) {
                lift.seen_from_front[f] = lift.seen_from_front[f] && pieces_[other].seen_from_front[f];
            }
            for (const int n : pieces_[other].ends) {
                is_path = is_path && n >= 0;
                at.insert(n);
            }
        }
        for (const int n : at) {
            if (n < 0) {
                continue;
            }
            const Node& here = nodes_[n];
            if (here.tag == Tag::wall) {
                is_path = is_path && here.pieces.size() == 2;
                if (is_path) {
                    const bool passes = pieces_[here.pieces[0]].face != pieces_[here.pieces[1]].face;
                    (passes ? lift.crossed : lift.touched).insert(here.wall);
                }
            } else {
                int& place = here.tag == Tag::start ? lift.from : lift.to;
                is_path = is_path && here.pieces.size() == 1 && place < 0;
                place = here.place;
            }
        }
        if (is_path && lift.from >= 0 && lift.to >= 0) {
            result_.lifts.push_back(lift);
        }
    }
}

const EdgeLifts& Oracle::lifts(int a, int b) {
    const Edge edge = edge_of(a, b);
    const auto known = lifts_.find(edge);
    if (known != lifts_.end()) {
        return known->second;
    }
    return lifts_.emplace(edge, EdgeLifter(*this, edge.first, edge.second).find()).first->second;
}

// --- The choice of places --------------------------------------------------------------------------------------------

std::vector<std::vector<int>> Oracle::scan_parts() const {
    std::map<int, std::set<int>> neighbours;
    for (std::size_t f = 0; f < scan_.faces.size(); ++f) {
        if (frozen_scan_[f]) {
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            neighbours[scan_.faces[f][k]].insert(scan_.faces[f][(k + 1) % 3]);
            neighbours[scan_.faces[f][(k + 1) % 3]].insert(scan_.faces[f][k]);
        }
    }
    std::vector<std::vector<int>> parts;
    std::set<int> seen;
    for (const auto& [vertex, unused] : neighbours) {
        if (!seen.insert(vertex).second) {
            continue;
        }
        std::vector<int> part{vertex};
        for (std::size_t n = 0; n < part.size(); ++n) {
            for (const int next : neighbours.at(part[n])) {
                if (seen.insert(next).second) {
                    part.push_back(next);
                }
            }
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

/// The places of all vertices of a part that follow from one of its first vertex, if all edges agree.
std::optional<std::map<int, int>> Oracle::section(const std::vector<int>& part, int place) {
    std::map<int, int> chosen{{part[0], place}};
    std::set<Edge> edges;
    const std::set<int> members(part.begin(), part.end());
    for (std::size_t f = 0; f < scan_.faces.size(); ++f) {
        for (int k = 0; k < 3 && !frozen_scan_[f] && members.contains(scan_.faces[f][0]); ++k) {
            edges.insert(edge_of(scan_.faces[f][k], scan_.faces[f][(k + 1) % 3]));
        }
    }
    bool goes_on = true;
    while (goes_on) {
        goes_on = false;
        for (const auto& [a, b] : edges) {
            if (chosen.contains(a) == chosen.contains(b)) {
                continue;
            }
            const bool forward = chosen.contains(a);
            if (is_fixed(a, b)) {
                chosen[forward ? b : a] = 0;
                goes_on = true;
                continue;
            }
            for (const Lift& lift : lifts(a, b).lifts) {
                if ((forward ? lift.from : lift.to) == chosen.at(forward ? a : b)) {
                    chosen[forward ? b : a] = forward ? lift.to : lift.from;
                    goes_on = true;
                    break;
                }
            }
        }
    }
    for (const auto& [a, b] : edges) {
        if (!chosen.contains(a) || !chosen.contains(b)) {
            return std::nullopt;
        }
        if (is_fixed(a, b)) {
            continue;
        }
        const auto& all = lifts(a, b).lifts;
        const bool agrees =
            std::any_of(all.begin(), all.end(), [&, from = chosen.at(a), to = chosen.at(b)](const Lift& l) {
                return l.from == from && l.to == to;
            });
        if (!agrees) {
            return std::nullopt;
        }
    }
    return chosen;
}

void Oracle::choose_places() {
    std::vector<std::map<int, int>> choices{{}};
    for (std::vector<int> part : scan_parts()) {
        const auto fewest = std::min_element(part.begin(), part.end(),
                                             [&](int a, int b) { return places_[a].size() < places_[b].size(); });
        std::iter_swap(part.begin(), fewest);
        std::vector<std::map<int, int>> more;
        for (std::size_t place = 0; place < places_[part[0]].size(); ++place) {
            if (const auto found = section(part, static_cast<int>(place))) {
                for (std::map<int, int> choice : choices) {
                    choice.insert(found->begin(), found->end());
                    more.push_back(std::move(choice));
                }
            }
        }
        if (more.empty()) {
            throw Refused{"edges"};
        }
        choices = std::move(more);
    }
    for (std::size_t c = 0; c < choices.size(); ++c) {
        try {
            check(choices[c]);
            return;
        } catch (const Refused&) {
            if (c + 1 == choices.size()) {
                throw;
            }
        }
    }
}

void Oracle::check(const std::map<int, int>& chosen) {
    check_only_place(chosen);
    check_corners(chosen);
    for (const auto& [edge, found] : lifts_) {
        for (const Lift& lift : found.lifts) {
            const bool is_chosen = chosen.contains(edge.first) && chosen.contains(edge.second) &&
                                   lift.from == chosen.at(edge.first) && lift.to == chosen.at(edge.second);
            if (is_chosen && (!lift.seen_from_front[0] || !lift.seen_from_front[1])) {
                throw Refused{"normal condition"};
            }
        }
    }
    tile(chosen);
}

/// No second place in a base face that shares a vertex with that of the chosen one.
void Oracle::check_only_place(const std::map<int, int>& chosen) const {
    for (const auto& [vertex, place] : chosen) {
        const Triangle& mine = base_.faces[places_[vertex][place].face];
        for (std::size_t p = 0; p < places_[vertex].size(); ++p) {
            const Triangle& other = base_.faces[places_[vertex][p].face];
            const bool adjacent = std::any_of(other.begin(), other.end(), [&](int v) {
                return std::find(mine.begin(), mine.end(), v) != mine.end();
            });
            if (static_cast<int>(p) != place && adjacent) {
                throw Refused{"second place"};
            }
        }
    }
}

/// m > 0 at the corners of every moving scan face. Lifted edges say the same, but base edges are not lifted.
void Oracle::check_corners(const std::map<int, int>& chosen) {
    for (std::size_t f = 0; f < scan_.faces.size(); ++f) {
        if (frozen_scan_[f]) {
            continue;
        }
        const Point n = normal_of(static_cast<int>(f));
        for (const int vertex : scan_.faces[f]) {
            const Place& place = places_[vertex][chosen.at(vertex)];
            int m = 0;
            if (place.kept >= 0) {
                m = sign(dot(n, d_[place.kept]));
            } else {
                const Prismoid& prismoid = prismoids_[prismoid_of_[place.face]];
                const Curve q = constant(q_[vertex]);
                Polynomial sum;
                for (int k = 0; k < 3; ++k) {
                    const auto& a = prismoid.a;
                    const Polynomial alpha = dot(prismoid.normal, cross(a[(k + 1) % 3] - q, a[(k + 2) % 3] - q));
                    sum = sum + dot(n, d_[prismoid.corners[k]]) * alpha;
                }
                Root t = place.t;
                m = t.sign_of(sum);
            }
            if (m <= 0) {
                throw Refused{"normal condition"};
            }
        }
    }
}

// --- The tiling of the base edges ------------------------------------------------------------------------------------

/// The parts of base edges that lie in scan triangles, and how they meet.
class Tiling {
public:
    Tiling(Oracle& oracle, const std::map<int, int>& chosen) : o_(oracle), chosen_(chosen) {}

    void check() {
        for (std::size_t f = 0; f < o_.scan_.faces.size(); ++f) {
            if (!o_.frozen_scan_[f]) {
                fill(static_cast<int>(f));
            }
        }
        compare();
    }

private:
    /// What is at an end of a part.
    struct End {
        enum class Kind { nothing, vertex, kept, crossing } kind = Kind::nothing;
        int vertex = -1; ///< base vertex
        Edge scan_edge{};
        WallNode node{};
        auto operator<=>(const End&) const = default;
    };
    struct Part {
        Edge base_edge;
        End lower, upper;
        bool is_image = false;
    };

    void fill(int face);
    void find_parts(int face, const BaseEdge& edge, std::vector<Part>& out);
    End end_at(int face, const BaseEdge& edge, Root& lambda, const std::array<Polynomial, 3>& inward,
               const Polynomial& l, const Polynomial& m);
    const Lift* lift_of(const Edge& scan_edge);
    void compare();

    Oracle& o_;
    const std::map<int, int>& chosen_;
    std::map<End, std::pair<int, int>> counts_; ///< of crossings: lower and upper ends of parts
    std::map<int, std::set<int>> faces_inside_; ///< per base vertex: the scan faces whose image holds it
    std::map<Edge, int> kept_ends_;             ///< (kept base vertex, other end): parts that begin there
};

const Lift* Tiling::lift_of(const Edge& scan_edge) {
    for (const Lift& lift : o_.lifts(scan_edge.first, scan_edge.second).lifts) {
        if (lift.from == chosen_.at(scan_edge.first) && lift.to == chosen_.at(scan_edge.second)) {
            return &lift;
        }
    }
    return nullptr;
}

Tiling::End Tiling::end_at(int face, const BaseEdge& edge, Root& lambda, const std::array<Polynomial, 3>& inward,
                           const Polynomial& l, const Polynomial& m) {
    const Triangle& corners = o_.scan_.faces[face];
    std::vector<int> zeros;
    for (int k = 0; k < 3; ++k) {
        if (lambda.sign_of(inward[k]) == 0) {
            zeros.push_back(k);
        }
    }
    if (lambda.is_rational() && (lambda.lo() == 0 || lambda.lo() == 1)) {
        const int vertex = lambda.lo() == 0 ? edge.i : edge.j;
        const int kept = o_.scan_of_[vertex];
        if (kept >= 0) {
            const bool is_corner = std::find(corners.begin(), corners.end(), kept) != corners.end();
            if (!is_corner || zeros.size() != 2) {
                return {};
            }
            const std::set<int> fan = o_.fan_under(face, vertex);
            const bool is_over =
                std::any_of(edge.faces.begin(), edge.faces.end(), [&](int f) { return fan.contains(f); });
            return is_over ? End{End::Kind::kept, vertex} : End{};
        }
        if (!zeros.empty()) {
            throw Tie{"pillar on a scan edge"};
        }
        return {End::Kind::vertex, vertex};
    }
    if (zeros.size() > 1) {
        throw Tie{"wall through a scan vertex"};
    }
    if (zeros.empty()) {
        return {};
    }
    const Edge scan_edge = edge_of(corners[zeros[0]], corners[(zeros[0] + 1) % 3]);
    if (o_.is_fixed(scan_edge.first, scan_edge.second)) {
        return {};
    }
    // The displacement -l/m, monotone in lambda, is one of the displacements at which the edge's line meets the wall.
    const auto& all = o_.lifts(scan_edge.first, scan_edge.second).wall_roots;
    const auto of_wall = all.find({edge.i, edge.j});
    if (of_wall == all.end() || lambda.sign_of(m) <= 0) {
        return {};
    }
    std::vector<Root> candidates = of_wall->second;
    for (int round = 0; round < 400; ++round) {
        const bool has_pole = m.sign_at(lambda.lo()) * m.sign_at(lambda.hi()) <= 0;
        if (!has_pole) {
            const Number t0 = -l.at(lambda.lo()) / m.at(lambda.lo());
            const Number t1 = -l.at(lambda.hi()) / m.at(lambda.hi());
            std::vector<int> possible;
            for (std::size_t r = 0; r < candidates.size(); ++r) {
                if (candidates[r].hi() >= std::min(t0, t1) && candidates[r].lo() <= std::max(t0, t1)) {
                    possible.push_back(static_cast<int>(r));
                }
            }
            if (possible.empty()) {
                return {};
            }
            if (possible.size() == 1) {
                return {End::Kind::crossing, -1, scan_edge, {{edge.i, edge.j}, possible[0]}};
            }
        }
        lambda.narrow();
        for (Root& candidate : candidates) {
            candidate.narrow();
        }
    }
    throw Tie{"crossing not identified"};
}

void Tiling::find_parts(int face, const BaseEdge& edge, std::vector<Part>& out) {
    const Triangle& corners = o_.scan_.faces[face];
    const Point n = o_.normal_of(face);
    const Point& v = o_.v_[edge.i];
    const Point& d = o_.d_[edge.i];
    const Curve position = line(v, o_.v_[edge.j] - v); // in lambda
    const Curve direction = line(d, o_.d_[edge.j] - d);
    const Polynomial l = dot(constant(n), position - constant(o_.q_[corners[0]]));
    const Polynomial m = dot(constant(n), direction);
    Number lo = o_.prismoids_[o_.prismoid_of_[edge.faces[0]]].lo;
    Number hi = o_.prismoids_[o_.prismoid_of_[edge.faces[0]]].hi;
    for (const int f : edge.faces) {
        lo = std::max(lo, o_.prismoids_[o_.prismoid_of_[f]].lo);
        hi = std::min(hi, o_.prismoids_[o_.prismoid_of_[f]].hi);
    }
    std::vector<Root> all;
    const auto may_hold = [&](const Polynomial& p) { // most triangles are elsewhere
        const std::vector<Root> some = roots(p, Number(0), Number(1));
        all.insert(all.end(), some.begin(), some.end());
        return !some.empty() || p.sign_at(Number(0)) >= 0;
    };
    const std::array<Polynomial, 2> in_range{Number(-1) * l - lo * m, hi * m + l};
    if (!may_hold(in_range[0]) || !may_hold(in_range[1]) || !may_hold(m)) {
        return;
    }
    std::vector<Polynomial> positive{m};
    std::array<Polynomial, 3> inward;
    for (int k = 0; k < 3; ++k) {
        const Point& q = o_.q_[corners[k]];
        const Curve normal = constant(cross(n, o_.q_[corners[(k + 1) % 3]] - q));
        inward[k] = m * dot(normal, position - constant(q)) - l * dot(normal, direction);
        positive.push_back(inward[k]);
        if (!may_hold(inward[k])) {
            return;
        }
    }
    std::vector<Root> cuts{Root(Number(0)), Root(Number(1))};
    for (Root& root : all) {
        const bool is_new =
            std::none_of(cuts.begin(), cuts.end(), [&](Root& known) { return known.compare(root) == 0; });
        if (is_new) {
            cuts.push_back(root);
        }
    }
    std::sort(cuts.begin(), cuts.end(), [](const Root& a, const Root& b) {
        Root x = a;
        Root y = b;
        return x.compare(y) < 0;
    });
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        const Number x = between(cuts[c], cuts[c + 1]);
        const bool holds =
            std::all_of(positive.begin(), positive.end(), [&](const Polynomial& p) { return p.sign_at(x) > 0; }) &&
            in_range[0].sign_at(x) >= 0 && in_range[1].sign_at(x) >= 0;
        if (holds) {
            const auto end = [&](Root& lambda) { return end_at(face, edge, lambda, inward, l, m); };
            out.push_back({{edge.i, edge.j}, end(cuts[c]), end(cuts[c + 1])});
        }
    }
}

/// The image of one scan face: all parts that hang together with its lifted border.
void Tiling::fill(int face) {
    const Triangle& corners = o_.scan_.faces[face];
    const ExactBox box({o_.q_[corners[0]], o_.q_[corners[1]], o_.q_[corners[2]]});
    std::vector<Part> parts;
    for (const auto& [edge, entry] : o_.base_edges_) {
        if (entry.box.meets(box)) {
            find_parts(face, entry, parts);
        }
    }
    std::map<Edge, const Lift*> border;
    std::set<std::pair<Edge, WallNode>> crossed; // by the border of this face
    for (int k = 0; k < 3; ++k) {
        const Edge edge = edge_of(corners[k], corners[(k + 1) % 3]);
        if (o_.is_fixed(edge.first, edge.second)) {
            continue;
        }
        const Lift* const lift = lift_of(edge);
        border[edge] = lift;
        for (const WallNode& node : lift->crossed) {
            crossed.emplace(edge, node);
        }
    }
    const auto on_border = [&](const End& end) {
        if (end.kind == End::Kind::kept) {
            return true;
        }
        if (end.kind != End::Kind::crossing || !border.contains(end.scan_edge)) {
            return false;
        }
        const Lift& lift = *border.at(end.scan_edge);
        return lift.crossed.contains(end.node) || lift.touched.contains(end.node);
    };
    std::set<int> inside;
    bool goes_on = true;
    while (goes_on) {
        goes_on = false;
        for (Part& part : parts) {
            const auto belongs = [&](const End& end) {
                return on_border(end) || (end.kind == End::Kind::vertex && inside.contains(end.vertex));
            };
            if (part.is_image || (!belongs(part.lower) && !belongs(part.upper))) {
                continue;
            }
            part.is_image = true;
            goes_on = true;
            for (const End& end : {part.lower, part.upper}) {
                if (end.kind == End::Kind::vertex) {
                    inside.insert(end.vertex);
                }
            }
        }
    }
    for (const Part& part : parts) {
        if (!part.is_image) {
            continue;
        }
        if (o_.base_edges_.at(part.base_edge).is_scan_edge) {
            throw Refused{"inside: over a scan edge"};
        }
        for (const End* const end : {&part.lower, &part.upper}) {
            if (end->kind == End::Kind::crossing && on_border(*end)) {
                auto& count = counts_[*end];
                ++(end == &part.lower ? count.first : count.second);
                crossed.erase({end->scan_edge, end->node});
            } else if (end->kind == End::Kind::kept) {
                const int other = part.base_edge.first == end->vertex ? part.base_edge.second : part.base_edge.first;
                ++kept_ends_[{end->vertex, other}];
            } else if (end->kind != End::Kind::vertex) {
                throw Refused{"inside: a base edge that ends"};
            }
        }
    }
    if (!crossed.empty()) {
        throw Refused{"inside: a crossing without its base edge"};
    }
    for (const int vertex : inside) {
        faces_inside_[vertex].insert(face);
        for (const auto& entry : o_.base_edges_) {
            const auto& edge = entry.first;
            if (edge.first != vertex && edge.second != vertex) {
                continue;
            }
            const auto starts_here = [&](const Part& part) {
                return part.is_image && part.base_edge == edge &&
                       ((part.lower.kind == End::Kind::vertex && part.lower.vertex == vertex) ||
                        (part.upper.kind == End::Kind::vertex && part.upper.vertex == vertex));
            };
            if (std::none_of(parts.begin(), parts.end(), starts_here)) {
                throw Refused{"inside: a pillar with a part of its star"};
            }
        }
    }
}

/// Every end meets one other.
void Tiling::compare() {
    for (const auto& [end, count] : counts_) {
        if (count != std::pair(1, 1)) {
            throw Refused{"tiling: a crossing"};
        }
    }
    std::set<int> moving;
    for (const auto& [edge, entry] : o_.base_edges_) {
        moving.insert(edge.first);
        moving.insert(edge.second);
        for (const auto& [from, to] : {edge, Edge{edge.second, edge.first}}) {
            if (o_.scan_of_[from] >= 0 && !entry.is_scan_edge) {
                const auto found = kept_ends_.find({from, to});
                if (found == kept_ends_.end() || found->second != 1) {
                    throw Refused{"tiling: a base edge from a kept vertex"};
                }
            }
        }
    }
    for (const int vertex : moving) {
        if (o_.scan_of_[vertex] < 0 && faces_inside_[vertex].size() != 1) {
            throw Refused{"tiling: a base vertex inside " + std::to_string(faces_inside_[vertex].size()) +
                          " scan faces"};
        }
    }
}

void Oracle::tile(const std::map<int, int>& chosen) {
    Tiling(*this, chosen).check();
}

} // namespace

Judgement judge(const BaseMesh& base, const Scan& scan) {
    try {
        Oracle(base, scan).judge();
        return {Judgement::Kind::represents, {}};
    } catch (const Refused& refused) {
        return {Judgement::Kind::refused, refused.reason};
    } catch (const Tie& tie) {
        return {Judgement::Kind::tie, tie.reason};
    }
}

} // namespace foldless::oracle
