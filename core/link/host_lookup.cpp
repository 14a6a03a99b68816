#include "core/link/host_lookup.h"

#include "core/link/address_text.h"

#include <algorithm>

namespace skyseal::link {

void HostLookup::start(const std::string &host, std::uint16_t port, Answer answer)
{
    abort();
    if (const auto literal = parseHost(host, port)) {
        answer(literal);
        return;
    }
    m_answer = std::move(answer);
    m_id = QHostInfo::lookupHost(QString::fromStdString(host), this,
                                 [this, port](const QHostInfo &info) { finish(info, port); });
}

void HostLookup::abort()
{
    if (m_id >= 0)
        QHostInfo::abortHostLookup(m_id);
    m_id = -1;
}

void HostLookup::finish(const QHostInfo &info, std::uint16_t port)
{
    // The answer was already queued when abort() was called.
    if (info.lookupId() != m_id)
        return;
    m_id = -1;
    const QList<QHostAddress> found = info.addresses();
    if (info.error() != QHostInfo::NoError || found.isEmpty()) {
        m_answer(std::nullopt);
        return;
    }
    // Prefer IPv4: autopilots and stations mostly listen on 0.0.0.0, while "localhost" often resolves to ::1 first.
    const auto four = std::find_if(found.begin(), found.end(),
                                   [](const QHostAddress &host) { return host.protocol() == QAbstractSocket::IPv4Protocol; });
    m_answer(fromQt(four != found.end() ? *four : found.front(), port));
}

} // namespace skyseal::link
