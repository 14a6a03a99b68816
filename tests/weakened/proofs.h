// Which attack test fails, in which check, under which weakness of the protocol.
#pragma once

#include <QtCore/QStringList>

namespace skyseal::test {

struct Proof
{
    const char *weaknesses; ///< names of core/base/weakness.h, joined by commas
    const char *program;
    const char *function;
    const char *check; ///< words of the check that must fail
};

/// An attack that no weakness of the channel's own makes succeed, and why.
struct Unproven
{
    const char *program;
    const char *function;
    const char *why;
};

inline constexpr Proof kProofs[] = {
    {"NoTagCheck", "channel_attack_record_test", "fabricatedRecords", "nothing made up is accepted"},
};

inline constexpr Unproven kUnproven[] = {
    {"", "", ""},
};

inline QStringList provenPrograms()
{
    QStringList out;
    for (const Proof &proof : kProofs)
        out << QLatin1String(proof.program);
    out.removeDuplicates();
    return out;
}

} // namespace skyseal::test
