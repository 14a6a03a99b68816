// The payload encryption of the code published with the paper MAVSec (2019): ChaCha20 or AES-256-CTR with a fixed key and a
// fixed nonce, restarted for every frame, without authentication. INSECURE: every frame is xored with the same bytes, so
// that one known plaintext decrypts all others, and anyone can change or forge frames. Used only for comparison: to read
// recordings and streams of that code, and to measure it.
#pragma once

#include "core/base/bytes.h"
#include "core/base/secret_bytes_fwd.h"
#include "core/crypto/mavsec_kind.h"

#include <memory>
#include <optional>

namespace skyseal::crypto {

class MavsecCipher
{
public:
    using Kind = MavsecKind;

    /// Bytes of the nonce (ChaCha20, RFC 8439) or of the first counter block (AES-256-CTR).
    static constexpr std::size_t nonceLength(Kind kind) { return kind == Kind::ChaCha20 ? 12 : 16; }

    /// `counter`: number of ChaCha20's first block; ignored for AES-256-CTR, whose nonce contains it. nullopt for a nonce of
    /// another length, and if the library fails.
    static std::optional<MavsecCipher> make(Kind kind, const Key32 &key, ByteView nonce, std::uint32_t counter,
                                            MavsecWork work = MavsecWork::Once);
    MavsecCipher(MavsecCipher &&) noexcept;
    MavsecCipher &operator=(MavsecCipher &&) noexcept;
    ~MavsecCipher();

    /// The keys and nonces of the published code, which are those of test vectors.
    static Key32 publishedKey(Kind kind);
    static Bytes publishedNonce(Kind kind);
    static constexpr std::uint32_t kPublishedCounter = kPublishedMavsecCounter;

    /// For a second link under the same key. Its cipher does not run for each frame.
    MavsecCipher clone() const;

    /// Decrypts, or encrypts, the payload of one frame in place: at most 255 bytes.
    void apply(MutableByteView payload) const;

private:
    class EachFrame;
    struct State;
    MavsecCipher();

    std::unique_ptr<State> m_state;
};

} // namespace skyseal::crypto
