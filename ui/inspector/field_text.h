// The text of a field of a raw payload: numbers, strings, names of enum entries.
#pragma once

#include "core/base/bytes.h"
#include "core/mavlink/dialect.h"

#include <QtCore/QString>

namespace skyseal::ui {

/// Returns the value, array elements separated by spaces. `payload` may be truncated; missing bytes count as zero.
QString fieldText(const mavlink::FieldInfo &field, ByteView payload, const mavlink::Dialect &dialect);

} // namespace skyseal::ui
