// A variant whose copying, moving and destroying are compiled in one file.
//
// Where a std::variant is copied, the compiler makes a function for each of its alternatives. The thirty of engine::Event took
// half a second in each of a hundred files.
#pragma once

#include <variant>

namespace skyseal {

/// `Variant`, a std::variant. The header that names it declares `extern template struct CompiledOnce<…>`, and one source file
/// has the same without `extern`.
template<typename Variant> struct CompiledOnce : Variant
{
    using Variant::Variant;
    CompiledOnce();
    CompiledOnce(const CompiledOnce &);
    CompiledOnce(CompiledOnce &&) noexcept;
    CompiledOnce &operator=(const CompiledOnce &);
    CompiledOnce &operator=(CompiledOnce &&) noexcept;
    ~CompiledOnce();

    // Qt's meta types look for both, and would compile them without asking whether the alternatives have them.
    friend bool operator==(const CompiledOnce &, const CompiledOnce &) = delete;
    friend bool operator<(const CompiledOnce &, const CompiledOnce &) = delete;
};

template<typename Variant> CompiledOnce<Variant>::CompiledOnce() = default;
template<typename Variant> CompiledOnce<Variant>::CompiledOnce(const CompiledOnce &) = default;
template<typename Variant> CompiledOnce<Variant>::CompiledOnce(CompiledOnce &&) noexcept = default;
template<typename Variant> CompiledOnce<Variant> &CompiledOnce<Variant>::operator=(const CompiledOnce &) = default;
template<typename Variant> CompiledOnce<Variant> &CompiledOnce<Variant>::operator=(CompiledOnce &&) noexcept = default;
template<typename Variant> CompiledOnce<Variant>::~CompiledOnce() = default;

} // namespace skyseal
