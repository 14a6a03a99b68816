#include "core/vehicle/file_transfer.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace skyseal::vehicle {

bool FileTransfer::addEntries(FtpListing part)
{
    m_listed += part.count;
    if (m_listed > kMostEntries)
        return false;
    std::ranges::move(part.entries, std::back_inserter(m_entries));
    return true;
}

void FileTransfer::setPart(std::shared_ptr<const KeptPart> kept, std::shared_ptr<PartSink> sink)
{
    if (isVirtual()) // it is made anew whenever it is opened
        return;
    m_kept = std::move(kept);
    m_sink = std::move(sink);
}

bool FileTransfer::beginPart()
{
    if (m_kept)
        return m_kept->size == m_size;
    if (m_sink)
        m_sink->begin(static_cast<std::uint32_t>(m_size), 0);
    return true;
}

bool FileTransfer::setSource(std::shared_ptr<const Bytes> content)
{
    if (!content || content->size() > kMostBytes)
        return false;
    m_source = std::move(content);
    m_size = m_announced = m_source->size();
    return true;
}

bool FileTransfer::announce(std::uint32_t size)
{
    m_announced = size;
    m_isEstimate = isVirtual();
    m_size = m_isEstimate ? std::min(kMostBytes, kLeastRoom + m_announced * 4) : m_announced;
    return m_size <= kMostBytes;
}

ByteView FileTransfer::sourceChunk(std::size_t index) const
{
    const std::size_t offset = index * kChunk;
    return ByteView(*m_source).subspan(offset, std::min(kChunk, m_size - offset));
}

void FileTransfer::store(std::size_t offset, ByteView data)
{
    m_content.resize(std::max(m_content.size(), offset + data.size()));
    std::ranges::copy(data, m_content.begin() + static_cast<std::ptrdiff_t>(offset));
}

void FileTransfer::take(std::uint32_t offset, ByteView data)
{
    store(offset, data);
    if (m_sink)
        m_sink->append(offset, data);
}

bool FileTransfer::endAt(std::size_t bytes)
{
    if (m_content.size() > bytes)
        return false;
    m_size = std::min(m_size, bytes);
    m_announced = m_size;
    m_isEstimate = false;
    return true;
}

bool FileTransfer::verify(std::optional<std::uint32_t> checksum)
{
    m_verified = checksum == mavlink::ftpChecksum(m_action == FileAction::Write ? *m_source : m_content);
    return m_verified || !checksum;
}

FileResult FileTransfer::takeResult(bool ok)
{
    FileResult result{.id = m_id, .action = m_action, .path = m_path, .ok = ok, .verified = m_verified};
    if (ok && m_action == FileAction::List)
        result.entries = std::make_shared<const std::vector<RemoteFile>>(std::move(m_entries));
    if (ok && m_action == FileAction::Read)
        result.content = std::make_shared<const Bytes>(std::move(m_content));
    m_entries.clear();
    m_content = {};
    m_source.reset();
    m_kept.reset();
    m_sink.reset();
    return result;
}

} // namespace skyseal::vehicle
