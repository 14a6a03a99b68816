// Selects one of several lambdas by the alternative of a variant.
#pragma once

namespace skyseal {

template<typename... F> struct Overloaded : F...
{
    using F::operator()...;
};
template<typename... F> Overloaded(F...) -> Overloaded<F...>;

} // namespace skyseal
