// Files on the vehicle: the requests of MAVLink FTP and their result. https://mavlink.io/en/services/ftp.html
#pragma once

#include "core/base/bytes.h"
#include "core/base/reason.h"
#include "core/vehicle/kept_part.h"
#include "core/vehicle/request_id.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace skyseal::vehicle {

struct RemoteFile
{
    std::string name;
    std::uint32_t size = 0; ///< bytes; 0 for a folder
    bool isFolder = false;
    bool operator==(const RemoteFile &) const = default;
};

/// Paths have at most 238 bytes, the data of one message without its last byte.
struct ListFolder
{
    std::string path;
};
/// Reads the whole file; its checksum is compared with the vehicle's if the vehicle computes one.
struct ReadFile
{
    std::string path;
    std::shared_ptr<const KeptPart> kept = {}; ///< goes on from here; then both ends must have the same checksum
    std::shared_ptr<PartSink> sink = {};       ///< takes what arrives; not of virtual files
};
/// Creates or replaces the file.
struct WriteFile
{
    std::string path;
    std::shared_ptr<const Bytes> content;
};
struct RemoveFile
{
    std::string path;
};

/// Ends a transfer of files or logs that is in progress; its result then says so.
struct CancelTransfer
{
    RequestId transfer{};
};

enum class FileAction : std::uint8_t { List, Read, Write, Remove };

struct FileResult
{
    RequestId id{};
    std::uint8_t systemId = 0;
    FileAction action{};
    std::string path = {};
    bool ok = false;
    Reason reason = {};            ///< why it failed
    bool changeUnanswered = false; ///< a write or removal that got no answer at all
    bool unfit = false;            ///< what has arrived, or was kept, is not the file: it must be read anew
    bool verified = false;         ///< the checksums of both ends are the same
    std::shared_ptr<const std::vector<RemoteFile>> entries = {}; ///< of List
    std::shared_ptr<const Bytes> content = {};                   ///< of Read
};

} // namespace skyseal::vehicle
