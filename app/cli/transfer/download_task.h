// A task that downloads a file or log, and goes on from what an earlier program kept of it.
#pragma once

#include "app/cli/transfer/part_file.h"
#include "app/cli/transfer/vehicle_task.h"
#include "app/common/format.h"
#include "app/common/output.h"
#include "core/base/json_writer.h"

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace skyseal::app {

/// `Result`: vehicle::FileResult or LogResult.
template<typename Result> class DownloadTask final : public VehicleTask
{
public:
    struct Download
    {
        std::string file;    ///< to be written
        std::string subject; ///< "file /a" or "log 1": what is kept is a part of this
        std::string prefix;  ///< of a failure: "/a: "
        std::function<vehicle::Request(std::shared_ptr<const vehicle::KeptPart>, std::shared_ptr<vehicle::PartSink>)> request;
        /// Writes the file. Returns what went wrong, or an empty text.
        std::function<std::string(const Result &)> take;
    };

    DownloadTask(const TaskSettings &settings, Download download) : VehicleTask(settings), m_download(std::move(download)) {}

protected:
    void start(const vehicle::VehicleState &) override
    {
        const std::string source = "vehicle " + std::to_string(systemId()) + " " + m_download.subject;
        m_part = std::make_shared<PartFile>(m_download.file, source);
        const auto kept = m_part->resume();
        m_isResumed = kept != nullptr;
        if (m_isResumed)
            reportResumed(*kept);
        ask(m_download.request(kept, m_part));
    }
    void fileEnded(const vehicle::FileResult &result) override { end(result); }
    void logEnded(const vehicle::LogResult &result) override { end(result); }

private:
    template<typename Other> void end(const Other &result)
    {
        if constexpr (std::is_same_v<Other, Result>) {
            if (result.ok)
                return save(result);
            if (result.unfit)
                m_part->remove();
            if (result.unfit && std::exchange(m_isResumed, false)) {
                reportRestarted(result.reason.text());
                return ask(m_download.request(nullptr, m_part));
            }
            finish(m_download.prefix + result.reason.text()
                   + (m_part->isOpen() ? "; " + m_part->path() + " keeps what has arrived" : std::string()));
        }
    }

    void save(const Result &result)
    {
        std::string problem = m_download.take(result);
        if (problem.empty())
            m_part->remove();
        finishSaved(std::move(problem));
    }

    void reportResumed(const vehicle::KeptPart &kept)
    {
        std::uint64_t bytes = 0;
        for (const vehicle::KeptPart::Piece &piece : kept.pieces)
            bytes += piece.size;
        if (!isJson())
            return remark(m_part->path() + ": goes on from " + counted(bytes, "byte"));
        JsonWriter out;
        out.beginObject().field("event", "resumed").field("file", m_part->path()).field("bytes", bytes).endObject();
        printLine(out.text());
    }

    void reportRestarted(const std::string &reason)
    {
        if (!isJson())
            return remark(m_part->path() + ": starts anew: " + reason);
        JsonWriter out;
        out.beginObject().field("event", "restarted").field("file", m_part->path()).field("reason", reason).endObject();
        printLine(out.text());
    }

    const Download m_download;
    std::shared_ptr<PartFile> m_part;
    bool m_isResumed = false;
};

} // namespace skyseal::app
