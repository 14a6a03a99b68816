#include "ui/security/remembered_suites.h"

#include "core/engine/text/qt_text.h"

#include <QtCore/QSettings>

namespace skyseal::ui {

namespace {

const QString kSuitesGroup = QStringLiteral("suites");

QString storeKeyOf(const crypto::PublicKey &peer)
{
    const auto bytes = QByteArray::fromRawData(reinterpret_cast<const char *>(peer.data()),
                                               static_cast<qsizetype>(peer.size()));
    return kSuitesGroup + QLatin1Char('/') + QString::fromLatin1(bytes.toHex());
}

bool isKept(crypto::SuiteId suite)
{
    return suite != crypto::SuiteId::None && !crypto::suiteInfo(suite).research;
}

} // namespace

void RememberedSuites::remember(const crypto::PublicKey &peer, crypto::SuiteId suite)
{
    if (!isKept(suite))
        return;
    m_store.beginGroup(kSuitesGroup);
    const bool isFull = m_store.childKeys().size() >= kMostPeers;
    m_store.endGroup();
    if (isFull && !m_store.contains(storeKeyOf(peer)))
        m_store.remove(kSuitesGroup); // of peers that have come and gone
    m_store.setValue(storeKeyOf(peer), engine::fromStd(crypto::suiteInfo(suite).name));
}

std::optional<crypto::SuiteId> RememberedSuites::of(const crypto::PublicKey &peer) const
{
    const auto suite = crypto::suiteFromName(m_store.value(storeKeyOf(peer)).toString().toStdString());
    return suite && isKept(*suite) ? suite : std::nullopt;
}

} // namespace skyseal::ui
