// The latest requests for single chunks of a file, by their sequence number: the answer of MAVLink FTP repeats the number plus
// one, and not the place in the file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace skyseal::vehicle {

class ChunkRequests
{
public:
    static constexpr std::size_t kKept = 256;

    void clear() { m_requests = {}; }
    void sent(std::uint16_t sequence, std::size_t chunk) { m_requests[sequence % kKept] = {sequence, chunk}; }
    /// The chunk whose request has this answer; nullopt if it is none of the latest ones.
    std::optional<std::size_t> answeredBy(std::uint16_t sequence) const
    {
        const auto of = static_cast<std::uint16_t>(sequence - 1);
        const Request &request = m_requests[of % kKept];
        return request.sequence == of ? request.chunk : std::nullopt;
    }

private:
    struct Request
    {
        std::uint16_t sequence = 0;
        std::optional<std::size_t> chunk;
    };

    std::array<Request, kKept> m_requests{};
};

} // namespace skyseal::vehicle
