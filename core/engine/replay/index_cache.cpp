#include "core/engine/replay/index_cache.h"

#include "core/base/save_file.h"
#include "core/log/open_log.h"

#include <QtCore/QCryptographicHash>
#include <QtCore/QDataStream>
#include <QtCore/QIODevice>

#include <filesystem>
#include <type_traits>

namespace skyseal::engine {

namespace {

using tlog::LogIndex;

// The file: kMagic, version, body, SHA-256 of the body. The hash finds damage; nobody but the user can write the file.
constexpr quint32 kMagic = 0x534b4958;
constexpr qsizetype kFrame = 64; ///< more than all but the body takes

QDataStream &withFormat(QDataStream &stream)
{
    stream.setVersion(QDataStream::Qt_6_0);
    return stream;
}

QByteArray hashOf(const QByteArray &body)
{
    return QCryptographicHash::hash(body, QCryptographicHash::Sha256);
}

/// Writes the fields of a structure that Reader reads in the same order.
class Writer
{
public:
    explicit Writer(QDataStream &out) : m_out(out) {}

    template<typename T>
    requires std::is_arithmetic_v<T>
    void field(T &value) { m_out << static_cast<qint64>(value); }
    void field(Duration &value) { m_out << static_cast<qint64>(value.count()); }
    void field(WallTime &value) { m_out << static_cast<qint64>(value.time_since_epoch().count()); }
    void field(tlog::LinkEvent::Kind &value) { m_out << static_cast<qint64>(value); }
    void field(std::string &value) { m_out << QByteArray::fromStdString(value); }
    template<typename T> bool count(std::vector<T> &list)
    {
        m_out << static_cast<qint64>(list.size());
        return true;
    }
    bool flag(bool value)
    {
        m_out << value;
        return value;
    }

private:
    QDataStream &m_out;
};

class Reader
{
public:
    explicit Reader(QDataStream &in) : m_in(in) {}

    template<typename T>
    requires std::is_arithmetic_v<T>
    void field(T &value) { value = static_cast<T>(number()); }
    void field(Duration &value) { value = Duration(number()); }
    void field(WallTime &value) { value = WallTime(std::chrono::microseconds(number())); }
    void field(tlog::LinkEvent::Kind &value)
    {
        using enum tlog::LinkEvent::Kind;
        const qint64 kind = number();
        value = kind == 0 ? Sealed : kind == 1 ? Switched : Plain;
    }
    void field(std::string &value)
    {
        QByteArray bytes;
        m_in >> bytes;
        value = bytes.toStdString();
    }
    /// Makes room for the entries that follow; false if they are too many.
    template<typename T> bool count(std::vector<T> &list)
    {
        const qint64 size = number();
        if (size < 0 || size > static_cast<qint64>(LogIndex::kListed)) {
            m_in.setStatus(QDataStream::ReadCorruptData);
            return false;
        }
        list.resize(static_cast<std::size_t>(size));
        return true;
    }
    bool flag(bool)
    {
        bool out = false;
        m_in >> out;
        return out;
    }

private:
    qint64 number()
    {
        qint64 out = 0;
        m_in >> out;
        return out;
    }

    QDataStream &m_in;
};

template<typename Codec, typename T, typename Each> void eachOf(Codec &codec, std::vector<T> &list, Each each)
{
    if (!codec.count(list))
        return;
    for (T &entry : list)
        each(entry);
}

/// Visits all fields, for either direction.
template<typename Codec> void visit(Codec &codec, LogIndex &index)
{
    const auto span = [&](tlog::LogSpan &one) {
        codec.field(one.from);
        codec.field(one.to);
    };
    WallTime first = index.first.value_or(WallTime());
    const bool hasFirst = codec.flag(index.first.has_value());
    codec.field(first);
    index.first = hasFirst ? std::optional(first) : std::nullopt;
    codec.field(index.length);
    codec.field(index.frames);
    codec.field(index.damaged);
    eachOf(codec, index.vehicles, [&](std::uint8_t &systemId) { codec.field(systemId); });
    eachOf(codec, index.modes, [&](tlog::ModeChange &mode) {
        codec.field(mode.at);
        codec.field(mode.systemId);
        codec.field(mode.type);
        codec.field(mode.autopilot);
        codec.field(mode.baseMode);
        codec.field(mode.customMode);
    });
    eachOf(codec, index.armed, [&](tlog::ArmedSpan &armed) {
        span(armed.span);
        codec.field(armed.systemId);
    });
    eachOf(codec, index.gaps, span);
    eachOf(codec, index.suites, [&](tlog::SuiteMark &mark) {
        codec.field(mark.at);
        codec.field(mark.event.kind);
        codec.field(mark.event.time);
        codec.field(mark.event.suite);
        codec.field(mark.event.peer);
    });
    codec.field(index.unreadableEvents);
    codec.field(index.omitted);
}

template<typename Codec> void visit(Codec &codec, RecordingInfo &recording, LogIndex &index)
{
    codec.field(recording.path);
    codec.field(recording.name);
    codec.field(recording.bytes);
    codec.field(recording.eventBytes);
    codec.field(recording.modified);
    visit(codec, index);
}

QByteArray encoded(const RecordingInfo &recording)
{
    QByteArray out;
    QDataStream stream(&out, QIODevice::WriteOnly);
    Writer writer(withFormat(stream));
    RecordingInfo copy = recording;
    LogIndex index = *recording.index;
    visit(writer, copy, index);
    return out;
}

std::vector<RecordingInfo> decoded(const QByteArray &body)
{
    std::vector<RecordingInfo> out;
    QDataStream stream(body);
    Reader reader(withFormat(stream));
    while (!stream.atEnd() && out.size() < IndexCache::kMostRecordings) {
        RecordingInfo recording;
        LogIndex index;
        visit(reader, recording, index);
        if (stream.status() != QDataStream::Ok)
            return {};
        recording.index = std::make_shared<const LogIndex>(std::move(index));
        out.push_back(std::move(recording));
    }
    return out;
}

} // namespace

std::vector<RecordingInfo> loadIndexes(const std::string &file)
{
    auto input = tlog::openLog(file);
    if (!input)
        return {};
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (error || size > IndexCache::kMostBytes)
        return {};
    QByteArray content(static_cast<qsizetype>(size), '\0');
    input->read(content.data(), content.size());
    content.truncate(static_cast<qsizetype>(input->gcount()));
    QDataStream stream(content);
    quint32 magic = 0, version = 0;
    QByteArray body, hash;
    withFormat(stream) >> magic >> version;
    if (magic != kMagic || version != IndexCache::kVersion)
        return {};
    stream >> body >> hash;
    return stream.status() == QDataStream::Ok && hash == hashOf(body) ? decoded(body) : std::vector<RecordingInfo>();
}

Result<void, InputError> saveIndexes(const std::string &file, const std::vector<RecordingInfo> &recordings)
{
    QByteArray body;
    std::size_t count = 0;
    for (const RecordingInfo &recording : recordings) {
        if (!recording.index)
            continue;
        const QByteArray one = encoded(recording);
        if (count == IndexCache::kMostRecordings
            || body.size() + one.size() + kFrame > static_cast<qsizetype>(IndexCache::kMostBytes))
            break;
        body += one;
        ++count;
    }
    QByteArray content;
    QDataStream stream(&content, QIODevice::WriteOnly);
    withFormat(stream) << kMagic << IndexCache::kVersion << body << hashOf(body);
    std::error_code error;
    std::filesystem::create_directories(std::filesystem::path(file).parent_path(), error); // the next error says why
    auto made = NewFile::replacing(file, 0600);
    if (!made)
        return tl::unexpected(made.error());
    made->write(asBytes(std::string_view(content.constData(), static_cast<std::size_t>(content.size()))));
    return made->commit();
}

} // namespace skyseal::engine
