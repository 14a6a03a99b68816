// What an ear on the wire can tell of keys: whether a life of an agent or a station repeats an ephemeral key of another, and
// whether a counter is sealed twice under the keys of one session, with different content.
#pragma once

#include <QtCore/QByteArray>
#include <QtCore/QHash>

namespace skyseal::test {

class KeyUses
{
public:
    /// A datagram between agent and station; others than records and messages of handshakes are ignored.
    void take(bool toGround, const QByteArray &bytes)
    {
        if (bytes.isEmpty())
            return;
        if (bytes.size() == 127 && bytes[0] == 0x59) {
            note(m_ephemeral, "station" + bytes.mid(1, 32), bytes.mid(1, 110));
        } else if (bytes.size() == 77 && bytes[0] == 0x5a) {
            note(m_ephemeral, "agent" + bytes.mid(3, 32), bytes);
            if (m_session != bytes.mid(3, 32))
                begin(bytes.mid(3, 32));
        } else if (bytes.size() >= 22 && (bytes[0] & 0xfc) == 0x50) {
            ++records;
            takeRecord(m_ways[toGround], bytes);
        }
    }

    int repeated = 0, sessions = 0;
    qint64 records = 0;

private:
    /// What one end has sealed in this session.
    struct Way
    {
        int epoch = 0;                       ///< the newest, of which a record shows the last two bits
        QHash<QByteArray, size_t> sealed[4]; ///< by the bits of the epoch: hashes of the records, by header
    };

    void takeRecord(Way &way, const QByteArray &bytes)
    {
        const int epoch = bytes[0] & 3;
        const QByteArray header = bytes.left(6);
        QHash<QByteArray, size_t> &sealed = way.sealed[epoch];
        const bool again = sealed.contains(header) && sealed.value(header) == qHash(bytes);
        if (const int ahead = (epoch - way.epoch) & 3; !again && (ahead == 1 || ahead == 2)) {
            way.epoch = epoch;
            sealed.clear(); // those of four epochs ago, under other keys
        }
        note(sealed, header, bytes);
    }

    // Of the content only a hash is kept: equal ones say that a message was sent again, which repeats nothing.
    void note(QHash<QByteArray, size_t> &known, const QByteArray &key, const QByteArray &content)
    {
        const size_t hash = qHash(content);
        repeated += known.value(key, hash) != hash;
        known.insert(key, hash);
    }
    void begin(const QByteArray &session)
    {
        ++sessions;
        m_session = session;
        m_ways[0] = m_ways[1] = {};
    }

    QHash<QByteArray, size_t> m_ephemeral; ///< hashes of what was sent
    Way m_ways[2];                         ///< of this session: to the vehicle, to the ground
    QByteArray m_session;                  ///< the ephemeral key of its answer
};

} // namespace skyseal::test
