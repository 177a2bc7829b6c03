#include <foldless/predicates/view_along.h>

#include <foldless/predicates/filtered.h>

#include <cmath>
#include <type_traits>

namespace foldless {

Sign turn_at(const DisplacedVertex& centre, const DisplacedVertex& a, const DisplacedVertex& b, double t) {
    for (const DisplacedVertex* x : {&centre, &a, &b}) {
        if (!x->v.allFinite() || !x->d.allFinite() || !std::isfinite(t)) {
            return Sign::undecided;
        }
    }
    return filtered([&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        const auto from_centre = [&](const DisplacedVertex& x) {
            return (exactly<Number>(x.v) - exactly<Number>(centre.v)) +
                   Number(t) * (exactly<Number>(x.d) - exactly<Number>(centre.d));
        };
        return sign_of(dot(exactly<Number>(centre.d), cross(from_centre(a), from_centre(b))));
    });
}

} // namespace foldless
