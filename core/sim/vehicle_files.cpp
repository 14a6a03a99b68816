#include "core/sim/vehicle_files.h"

#include "core/sim/packed_parameters.h"

#include <cstdio>

namespace skyseal::sim {

namespace {

constexpr std::string_view kParameterFolder = "@PARAM", kParameterFile = "@PARAM/param.pck";
constexpr std::string_view kLogFolder = "APM/LOGS", kNewestLog = "LASTLOG.TXT";

std::string logName(const FlightLog &log)
{
    char name[24];
    std::snprintf(name, sizeof name, "%08u.BIN", static_cast<unsigned>(log.number));
    return name;
}

std::string inLogFolder(std::string_view name)
{
    return std::string(kLogFolder) + "/" + std::string(name);
}

/// Whether a path is a folder or something in it.
bool isWithin(std::string_view path, std::string_view folder)
{
    return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}

/// Without what follows a '?'.
std::string_view pathOf(std::string_view name)
{
    return name.substr(0, name.find('?'));
}

} // namespace

VehicleFiles::VehicleFiles(FileStore &card, FlightLogs &logs, Autopilot &autopilot)
    : m_card(card), m_logs(logs), m_autopilot(autopilot)
{
    for (const char *folder : {"APM", "APM/LOGS"}) {
        if (!m_card.list(folder))
            static_cast<void>(m_card.makeDirectory(folder));
    }
}

bool VehicleFiles::isParameterFile(std::string_view path)
{
    return FileStore::normalised(pathOf(path)).value_or("") == kParameterFile;
}

StoreResult<std::string> VehicleFiles::changeable(std::string_view path)
{
    auto whole = FileStore::normalised(path);
    if (!whole)
        return whole;
    if (whole->empty() || *whole == "APM" || isWithin(*whole, kLogFolder) || isWithin(*whole, kParameterFolder))
        return fail(FileError::Protected);
    return whole;
}

std::optional<std::size_t> VehicleFiles::findLog(const std::string &path) const
{
    for (std::size_t i = 0; i < m_logs.count(); ++i) {
        if (path == inLogFolder(logName(m_logs.log(i))))
            return i;
    }
    return std::nullopt;
}

std::string VehicleFiles::newestLog() const
{
    return std::to_string(m_logs.log(m_logs.count() - 1).number) + "\n";
}

StoreResult<std::vector<FileEntry>> VehicleFiles::list(std::string_view directory) const
{
    const auto path = FileStore::normalised(directory);
    if (!path)
        return fail(path.error());
    if (*path == kParameterFolder) {
        const std::size_t size = packParameters(m_autopilot.parameters(), {}).size();
        return std::vector<FileEntry>{{"param.pck", false, size}};
    }
    auto entries = m_card.list(*path);
    if (entries && path->empty())
        entries->push_back({std::string(kParameterFolder), true, 0});
    if (entries && *path == kLogFolder && m_logs.count() > 0) {
        for (std::size_t i = 0; i < m_logs.count(); ++i)
            entries->push_back({logName(m_logs.log(i)), false, m_logs.log(i).bytes.size()});
        entries->push_back({std::string(kNewestLog), false, newestLog().size()});
    }
    return entries;
}

StoreResult<Bytes> VehicleFiles::read(std::string_view name) const
{
    if (isParameterFile(name)) {
        const std::size_t query = name.find('?');
        const auto selection = packedSelection(query == std::string_view::npos ? "" : name.substr(query + 1));
        Bytes packed;
        if (selection)
            packed = packParameters(m_autopilot.parameters(), *selection);
        return packed.empty() ? StoreResult<Bytes>(fail(FileError::Invalid)) : packed;
    }
    const auto path = FileStore::normalised(name);
    if (!path)
        return fail(path.error());
    if (const auto log = findLog(*path))
        return m_logs.log(*log).bytes;
    if (*path == inLogFolder(kNewestLog) && m_logs.count() > 0) {
        const std::string text = newestLog();
        return Bytes(text.begin(), text.end());
    }
    const auto content = m_card.read(*path);
    if (!content)
        return fail(content.error());
    return Bytes(content->begin(), content->end());
}

StoreResult<void> VehicleFiles::create(std::string_view path, bool truncate)
{
    return changeable(path).and_then([&](const std::string &whole) { return m_card.create(whole, truncate); });
}

StoreResult<void> VehicleFiles::write(std::string_view path, std::uint32_t offset, ByteView bytes)
{
    return changeable(path).and_then([&](const std::string &whole) { return m_card.write(whole, offset, bytes); });
}

StoreResult<void> VehicleFiles::truncate(std::string_view path, std::uint32_t size)
{
    return changeable(path).and_then([&](const std::string &whole) { return m_card.truncate(whole, size); });
}

StoreResult<void> VehicleFiles::remove(std::string_view path)
{
    if (const auto log = findLog(FileStore::normalised(path).value_or(""))) {
        if (m_autopilot.armed())
            return fail(FileError::Protected); // it is being written
        m_logs.remove(*log);
        return {};
    }
    return changeable(path).and_then([&](const std::string &whole) { return m_card.remove(whole); });
}

StoreResult<void> VehicleFiles::makeDirectory(std::string_view path)
{
    const auto existing = FileStore::normalised(path);
    if (existing && m_card.list(*existing))
        return fail(FileError::Exists);
    return changeable(path).and_then([&](const std::string &whole) { return m_card.makeDirectory(whole); });
}

StoreResult<void> VehicleFiles::removeDirectory(std::string_view path)
{
    return changeable(path).and_then([&](const std::string &whole) { return m_card.removeDirectory(whole); });
}

StoreResult<void> VehicleFiles::rename(std::string_view from, std::string_view to)
{
    const auto source = changeable(from), target = changeable(to);
    if (!source || !target)
        return fail(source ? target.error() : source.error());
    return m_card.rename(*source, *target);
}

StoreResult<void> VehicleFiles::storeParameters(ByteView file)
{
    if (!unpackParameters(file, m_autopilot.parameters()))
        return fail(FileError::Invalid);
    return {};
}

} // namespace skyseal::sim
