// A file that grows by whole entries: after an error it ends with the last whole one, or is gone if there is none. Used by one
// thread.
#pragma once

#include "core/base/bytes.h"

#include <cstdint>
#include <string>

namespace skyseal::engine {

class RecordingFile
{
public:
    RecordingFile() = default;
    RecordingFile(const RecordingFile &) = delete;
    RecordingFile &operator=(const RecordingFile &) = delete;
    ~RecordingFile() { close(); }

    /// Creates a file that only its owner can read. Returns false, with the reason in errno, also if the name is taken.
    bool create(const std::string &name);
    bool isOpen() const { return m_descriptor >= 0; }
    /// Of the last file; empty before the first.
    const std::string &name() const { return m_name; }

    /// Returns false, with the reason in errno, if not all was written: then call closeAfterError().
    bool append(ByteView bytes);
    void sync();
    /// Syncs what was written.
    void close();
    /// Removes an empty file and an incomplete entry.
    void closeAfterError();

private:
    int m_descriptor = -1;
    std::string m_name;
    std::uint64_t m_size = 0; ///< of whole entries
};

} // namespace skyseal::engine
