// The voice of a build without speech-dispatcher: there is none.
#include "ui/alerts/speech.h"

namespace skyseal::ui {

std::unique_ptr<Voice> desktopVoice()
{
    return nullptr;
}

bool isDesktopVoiceBuilt()
{
    return false;
}

} // namespace skyseal::ui
