// How the facts of two conversations (reference_conversation.h) are compared: rates within a tenth, answers exactly and in
// their order, ranges within a tolerance for each field.
#pragma once

#include "tests/sim/reference_conversation.h"

namespace skyseal::sim {

/// Hz.
bool isSameRate(double rate, double reference);

/// Whether the range of the field (MESSAGE.field) exceeds that of the reference by no more than its tolerance.
bool isWithin(ReferenceFacts::Range range, ReferenceFacts::Range reference, const std::string &field);

/// Answers of one step, in a line.
std::string joined(const std::vector<std::string> &answers);

/// What is different in `measured`, one line each: "rate VFR_HUD: 10 Hz on file, 8 measured". Messages below 1 Hz are too rare
/// for the time of the conversation, and are not compared.
std::vector<std::string> changesOf(const ReferenceFacts &measured, const ReferenceFacts &onFile);

} // namespace skyseal::sim
