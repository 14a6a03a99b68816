// Saves whole files: the old file stays until the new content is on the disk, and it stays for good if that fails, as on a full
// disk. A reader never sees a part of the new content, even if the process is killed while it writes.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <optional>
#include <string>
#include <utility>

#include <sys/types.h>

namespace skyseal {

/// The new version of a file: written beside the old one, and takes its place in commit(). Without a commit() that succeeds
/// nothing remains of it.
class NewFile
{
public:
    /// `mode`: the permissions, whatever those of the old file are. A symbolic link, pipe or device at `path` is replaced.
    static Result<NewFile, InputError> replacing(std::string path, ::mode_t mode);
    /// As replacing(), for the file that a user names: keeps the permissions of an old file and follows symbolic links. A
    /// pipe or device, such as /dev/stdout, is not replaced: the content goes into it.
    static Result<NewFile, InputError> saving(std::string path);

    ~NewFile();
    NewFile(NewFile &&other) noexcept;
    NewFile &operator=(NewFile &&) = delete;

    /// Appends. After a failure, which commit() reports, it does nothing and returns false.
    bool write(ByteView bytes);
    /// Syncs the content to the disk and puts it in the place of the old file. The error says why there is no new file.
    Result<void, InputError> commit();

private:
    explicit NewFile(std::string path) : m_path(std::move(path)) {}
    bool create(std::optional<::mode_t> mode);
    bool fail();
    InputError error() const;

    std::string m_path;      ///< of the old file
    std::string m_temporary; ///< empty: writes into the file at m_path, which is opened by the first write()
    int m_descriptor = -1;
    int m_error = 0; ///< errno of the first failure
};

/// Saves a file with NewFile::saving().
Result<void, InputError> saveFile(std::string path, ByteView content);

} // namespace skyseal
