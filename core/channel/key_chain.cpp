#include "core/channel/key_chain.h"

#include "core/base/byte_writer.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/kdf.h"

namespace skyseal::channel {

namespace {

Key32 extract(const Key32 &fromInitiator, const Key32 &fromResponder, ByteView handshakeHash)
{
    SecretBytes<64> both;
    ByteWriter writer(both.mutableView());
    writer.bytes(fromInitiator.view());
    writer.bytes(fromResponder.view());
    return crypto::hkdfExtractSha256(handshakeHash, both.view());
}

} // namespace

KeyChain::KeyChain(const Key32 &fromInitiator, const Key32 &fromResponder, ByteView handshakeHash)
    : m_secret(extract(fromInitiator, fromResponder, handshakeHash))
{}

EpochSecrets KeyChain::begin(crypto::SuiteId suite) const
{
    return derive(m_secret, Epoch{0}, suite, {}, {});
}

EpochSecrets KeyChain::advance(Epoch epoch, crypto::SuiteId suite, const SwitchSecret &exchanged) const
{
    const Key32 chain = crypto::hkdfExtractSha256(m_secret.view(), exchanged.shared.view());
    return derive(chain, epoch, suite, exchanged.proposer, exchanged.answerer);
}

EpochSecrets KeyChain::derive(const Key32 &chain, Epoch epoch, crypto::SuiteId suite, const crypto::PublicKey &proposer,
                              const crypto::PublicKey &answerer)
{
    const auto expand = [&](std::string_view use) {
        std::array<std::uint8_t, 96> info;
        ByteWriter writer(info);
        writer.bytes(asBytes("skyseal v1 epoch "));
        writer.bytes(asBytes(use));
        writer.u32(static_cast<std::uint32_t>(epoch));
        writer.u8(static_cast<std::uint8_t>(suite));
        writer.bytes(proposer);
        writer.bytes(answerer);
        return crypto::hkdfExpandKey(chain, writer.written());
    };
    return {expand("initiator"), expand("responder"), KeyChain(expand("next"))};
}

} // namespace skyseal::channel
