// FILE.part: the received part of FILE, from which an interrupted download continues, also after the program was killed.
#pragma once

#include "core/vehicle/kept_part.h"

#include <memory>
#include <string>

namespace skyseal::app {

/// Keeps nothing if FILE is no regular file, such as a pipe; if FILE.part is no journal of this program, or another program
/// writes it; or when the disk is full: then the download goes on without it.
class PartFile final : public vehicle::PartSink
{
public:
    /// `file`: FILE. `source`: what is downloaded.
    PartFile(const std::string &file, std::string source);
    ~PartFile() override;
    PartFile(const PartFile &) = delete;
    PartFile &operator=(const PartFile &) = delete;

    const std::string &path() const { return m_path; }
    /// True while there is a journal.
    bool isOpen() const { return m_descriptor >= 0; }
    /// The part of the source that an earlier program has fetched; null if there is none.
    std::shared_ptr<const vehicle::KeptPart> resume();
    /// Of a download that has succeeded, or whose content is unfit.
    void remove();

    void begin(std::uint32_t size, std::uint32_t stamp) override;
    void append(std::uint32_t offset, ByteView bytes) override;

private:
    bool open(int flags);
    void close();
    Bytes read() const;
    void write(ByteView bytes);

    std::string m_path, m_source;
    int m_descriptor = -1;
    bool m_isUsed = true; ///< false: nothing is kept
};

} // namespace skyseal::app
