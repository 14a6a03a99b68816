// A field of a raw payload as people read it: numbers, text, names of enum entries.
#pragma once

#include "core/base/bytes.h"
#include "core/mavlink/dialect.h"

#include <QtCore/QString>

namespace skyseal::ui {

/// The value (arrays separated by spaces); `payload` may be shorter than the message, what is missing counts as zero.
QString fieldText(const mavlink::FieldInfo &field, ByteView payload, const mavlink::Dialect &dialect);

} // namespace skyseal::ui
