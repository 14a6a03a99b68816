#include "core/vehicle/result_reason.h"

#include "core/mavlink/enums.h"

#include <iterator>

namespace skyseal::vehicle {

namespace {

constexpr Sentence kOtherResult = sentence("Reason", "result %1");

constexpr Sentence kCommandResults[] = {
    sentence("Reason", "accepted"),
    sentence("Reason", "temporarily rejected"),
    sentence("Reason", "denied"),
    sentence("Reason", "not supported"),
    sentence("Reason", "failed"),
    sentence("Reason", "in progress"),
    sentence("Reason", "cancelled"),
    sentence("Reason", "accepted as COMMAND_LONG only"),
    sentence("Reason", "accepted as COMMAND_INT only"),
    sentence("Reason", "coordinate frame not supported"),
    sentence("Reason", "this station is not in control"),
};

constexpr Sentence kMissionResults[] = {
    sentence("Reason", "accepted"),
    sentence("Reason", "the vehicle reports an error"),
    sentence("Reason", "coordinate frame not supported"),
    sentence("Reason", "command not supported"),
    sentence("Reason", "no space left on the vehicle"),
    sentence("Reason", "an item is invalid"),
    sentence("Reason", "parameter 1 is invalid"),
    sentence("Reason", "parameter 2 is invalid"),
    sentence("Reason", "parameter 3 is invalid"),
    sentence("Reason", "parameter 4 is invalid"),
    sentence("Reason", "x (latitude) is invalid"),
    sentence("Reason", "y (longitude) is invalid"),
    sentence("Reason", "z (altitude) is invalid"),
    sentence("Reason", "an item arrived out of sequence"),
    sentence("Reason", "not accepting missions from this station"),
    sentence("Reason", "cancelled"),
};

/// By MAV_PARAM_ERROR, from DOES_NOT_EXIST on.
constexpr Sentence kParameterErrors[] = {
    sentence("Reason", "the vehicle has no such parameter"),
    sentence("Reason", "the vehicle refuses the value: it is out of range"),
    sentence("Reason", "the vehicle denies the permission"),
    sentence("Reason", "the vehicle has no such component"),
    sentence("Reason", "the parameter is read-only"),
    sentence("Reason", "the vehicle does not support the type of the parameter"),
    sentence("Reason", "the vehicle has the parameter with another type"),
    sentence("Reason", "the vehicle cannot read the parameter"),
};
constexpr Sentence kOtherParameterError = sentence("Reason", "the vehicle refuses it with error %1");

constexpr Sentence kFtpFailure = sentence("Reason", "the vehicle reports a failure");
constexpr Sentence kFtpSize = sentence("Reason", "the vehicle refuses the size");
constexpr Sentence kFtpClosed = sentence("Reason", "the vehicle has closed the file");
constexpr Sentence kFtpBusy = sentence("Reason", "too many files are open on the vehicle");
constexpr Sentence kFtpEnd = sentence("Reason", "end of file");
constexpr Sentence kFtpUnsupported = sentence("Reason", "not supported by the vehicle");
constexpr Sentence kFtpExists = sentence("Reason", "the file exists");
constexpr Sentence kFtpProtected = sentence("Reason", "the file is protected");
constexpr Sentence kFtpNotFound = sentence("Reason", "no such file or folder");
constexpr Sentence kFtpSystemError = sentence("Reason", "the vehicle reports error %1");
constexpr Sentence kFtpOtherError = sentence("Reason", "the vehicle reports error code %1");

constexpr std::uint8_t kNoSuchFile = 2; ///< ENOENT

} // namespace

Reason commandResultReason(std::uint8_t result)
{
    return result < std::size(kCommandResults) ? Reason(kCommandResults[result]) : kOtherResult(result);
}

Reason missionResultReason(std::uint8_t result)
{
    return result < std::size(kMissionResults) ? Reason(kMissionResults[result]) : kOtherResult(result);
}

Reason parameterErrorReason(std::uint8_t error)
{
    const std::size_t row = error - std::size_t(mavlink::MAV_PARAM_ERROR_DOES_NOT_EXIST);
    return row < std::size(kParameterErrors) ? Reason(kParameterErrors[row]) : kOtherParameterError(error);
}

Reason ftpErrorReason(const mavlink::FtpMessage &refusal)
{
    const std::uint8_t error = refusal.error().value_or(mavlink::MAV_FTP_ERR_FAIL);
    const std::uint8_t number = refusal.size > 1 ? refusal.data[1] : 0;
    switch (error) {
    case mavlink::MAV_FTP_ERR_FAIL: return kFtpFailure;
    case mavlink::MAV_FTP_ERR_FAILERRNO: return number == kNoSuchFile ? Reason(kFtpNotFound) : kFtpSystemError(number);
    case mavlink::MAV_FTP_ERR_INVALIDDATASIZE: return kFtpSize;
    case mavlink::MAV_FTP_ERR_INVALIDSESSION: return kFtpClosed;
    case mavlink::MAV_FTP_ERR_NOSESSIONSAVAILABLE: return kFtpBusy;
    case mavlink::MAV_FTP_ERR_EOF: return kFtpEnd;
    case mavlink::MAV_FTP_ERR_UNKNOWNCOMMAND: return kFtpUnsupported;
    case mavlink::MAV_FTP_ERR_FILEEXISTS: return kFtpExists;
    case mavlink::MAV_FTP_ERR_FILEPROTECTED: return kFtpProtected;
    case mavlink::MAV_FTP_ERR_FILENOTFOUND: return kFtpNotFound;
    }
    return kFtpOtherError(error);
}

} // namespace skyseal::vehicle
