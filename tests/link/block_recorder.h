// A listener that keeps the received blocks, and helpers of the link tests.
#pragma once

#include "core/link/make_link.h"

#include <functional>
#include <vector>

namespace skyseal::test {

class BlockRecorder : public link::LinkListener
{
public:
    struct Block
    {
        Path path;
        Bytes bytes;
    };

    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> received) override
    {
        ++batches;
        largestBatch = std::max(largestBatch, received.size());
        for (const link::ReceivedBlock &block : received)
            blocks.push_back({block.path, Bytes(block.bytes.begin(), block.bytes.end())});
        if (onReceived)
            onReceived(link);
    }
    void linkPeerJoined(link::Link &, const Path &path) override { joined.push_back(path); }
    void linkPeerLeft(link::Link &, const Path &path) override { left.push_back(path); }

    /// The bytes of all blocks in order.
    std::string stream() const
    {
        std::string out;
        for (const Block &block : blocks)
            out += asText(block.bytes);
        return out;
    }

    std::vector<Block> blocks;
    std::vector<Path> joined;
    std::vector<Path> left;
    std::size_t batches = 0;
    std::size_t largestBatch = 0;
    std::function<void(link::Link &)> onReceived;
};

inline std::unique_ptr<link::Link> openLink(const std::string &url, link::LinkListener &listener,
                                            const link::LinkOptions &options = {}, LinkId id = LinkId{1})
{
    const auto parsed = link::LinkUrl::parse(url);
    if (!parsed)
        qFatal("%s", parsed.error().text().c_str());
    auto out = link::makeLink(*parsed, id, listener, options);
    out->open();
    return out;
}

inline std::string portOf(const link::Link &link)
{
    return std::to_string(link.localEndpoint().value().port);
}

} // namespace skyseal::test
