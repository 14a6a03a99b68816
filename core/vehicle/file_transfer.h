// A file or folder on its way from or to the vehicle: its size, as far as it is known, and the content that has arrived. A file
// is a row of chunks; sizes and folders are bounded, whatever the vehicle sends.
//
// The announced size of virtual files (ArduPilot's @PARAM and @SYS) is an estimate (AP_Filesystem_Param::stat(): twelve bytes a
// parameter): a short chunk or the answer "end of file" ends them.
#pragma once

#include "core/mavlink/ftp_message.h"
#include "core/vehicle/ftp_listing.h"
#include "core/vehicle/remote_file.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::vehicle {

class FileTransfer
{
public:
    static constexpr std::size_t kChunk = mavlink::FtpMessage::kMostData;
    static constexpr std::size_t kMostBytes = 256u << 20; ///< of a file
    static constexpr std::size_t kLeastRoom = 64u << 10;  ///< for a file whose size is an estimate
    static constexpr std::size_t kMostEntries = 10'000;   ///< of a folder

    FileTransfer() = default;
    FileTransfer(RequestId id, FileAction action, std::string path) : m_id(id), m_action(action), m_path(std::move(path)) {}

    RequestId id() const { return m_id; }
    FileAction action() const { return m_action; }
    const std::string &path() const { return m_path; }
    bool isVirtual() const { return m_path.starts_with('@'); }

    /// Adds a part of the folder. Returns false if it has too many entries.
    bool addEntries(FtpListing part);
    /// Entries of the folder so far, those that were skipped included.
    std::uint32_t listed() const { return m_listed; }

    /// Of a file to be read, unless it is virtual: goes on from `kept`, and `sink` takes what arrives. Either may be null.
    void setPart(std::shared_ptr<const KeptPart> kept, std::shared_ptr<PartSink> sink);
    /// The part of an earlier attempt; null if the transfer begins anew.
    const KeptPart *kept() const { return m_kept.get(); }
    /// The size is known: tells the sink what begins. Returns false if what is kept has another size.
    bool beginPart();

    /// The file to be written. Returns false if there is none or it is too large.
    bool setSource(std::shared_ptr<const Bytes> content);
    /// The size of the file to be read, as the vehicle says. Returns false if it is too large.
    bool announce(std::uint32_t size);
    /// As far as it is known; while isEstimate(), an upper limit.
    std::size_t size() const { return m_size; }
    std::size_t chunks() const { return (m_size + kChunk - 1) / kChunk; }
    bool isEstimate() const { return m_isEstimate; }
    /// For people.
    std::size_t announcedSize() const { return m_announced; }

    /// A chunk of the file to be written.
    ByteView sourceChunk(std::size_t index) const;
    /// Bytes of the file that is read, up to the last one that arrived.
    std::size_t end() const { return m_content.size(); }
    /// Stores bytes of the file that is read. `offset` is within the size.
    void store(std::size_t offset, ByteView data);
    /// The same for bytes that have arrived, which the sink takes as well.
    void take(std::uint32_t offset, ByteView data);
    /// The file ends sooner than it was announced. Returns false if more has arrived already.
    bool endAt(std::size_t bytes);

    /// Compares the content with the vehicle's checksum; nullopt if it computes none. Returns false if they differ.
    bool verify(std::optional<std::uint32_t> checksum);
    /// Hands over what has arrived, if the transfer succeeded, and forgets it.
    FileResult takeResult(bool ok);

private:
    RequestId m_id{};
    FileAction m_action{};
    std::string m_path;
    std::vector<RemoteFile> m_entries;
    std::uint32_t m_listed = 0;
    Bytes m_content;                       ///< read so far
    std::shared_ptr<const Bytes> m_source; ///< to be written
    std::shared_ptr<const KeptPart> m_kept;
    std::shared_ptr<PartSink> m_sink;
    std::size_t m_size = 0;
    std::size_t m_announced = 0;
    bool m_isEstimate = false;
    bool m_verified = false;
};

} // namespace skyseal::vehicle
