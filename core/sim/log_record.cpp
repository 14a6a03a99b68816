#include "core/sim/log_record.h"

namespace skyseal::sim {

namespace {

std::size_t fieldSize(char letter)
{
    switch (letter) {
    case 'Q': return 8;
    case 'I':
    case 'L':
    case 'e':
    case 'f':
    case 'n': return 4;
    case 'H':
    case 'c':
    case 'C': return 2;
    case 'N': return 16;
    case 'Z': return 64;
    default: return 1; // B, M
    }
}

} // namespace

std::size_t LogRecord::length(const LogLayout &layout)
{
    std::size_t size = 3;
    for (const char letter : layout.format)
        size += fieldSize(letter);
    return size;
}

LogRecord LogRecord::describe(const LogLayout &layout)
{
    LogRecord record(kFormatType);
    record.put(layout.type).put(static_cast<std::uint8_t>(length(layout)));
    record.text(layout.name, 4).text(layout.format, 16).text(layout.columns, 64);
    return record;
}

} // namespace skyseal::sim
