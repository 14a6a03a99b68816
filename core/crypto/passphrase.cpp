#include "core/crypto/passphrase.h"

#include "core/base/secret_bytes.h"

#include <algorithm>
#include <utility>

namespace skyseal::crypto {

Passphrase::Passphrase() : m_bytes(std::make_unique<SecretBytes<kMaxLength>>()) {}
Passphrase::~Passphrase() = default;

Passphrase::Passphrase(Passphrase &&other) noexcept : m_bytes(std::move(other.m_bytes)), m_size(std::exchange(other.m_size, 0))
{}

Passphrase &Passphrase::operator=(Passphrase &&other) noexcept
{
    m_bytes = std::move(other.m_bytes);
    m_size = std::exchange(other.m_size, 0);
    return *this;
}

std::optional<Passphrase> Passphrase::fromBytes(ByteView bytes)
{
    if (bytes.empty() || bytes.size() > kMaxLength)
        return std::nullopt;
    Passphrase out;
    std::ranges::copy(bytes, out.m_bytes->mutableView().begin());
    out.m_size = bytes.size();
    return out;
}

Passphrase Passphrase::clone() const
{
    return *fromBytes(view());
}

ByteView Passphrase::view() const
{
    return m_bytes ? ByteView(m_bytes->view()).first(m_size) : ByteView();
}

bool Passphrase::equals(const Passphrase &other) const
{
    return m_size == other.m_size && (m_size == 0 || m_bytes->equals(*other.m_bytes));
}

} // namespace skyseal::crypto
