#pragma once

// What the light panel offers. Interface thread only.

#include <QStringList>
#include <QVector>

#include "ui/docks/light_choice.h"

namespace cutis {

// The lights of the built-in library in the groups of the light panel, and the observers and
// cameras to look with. Names are those of src/files/spectral_library.h.
QVector<LightGroup> lightGroups();
QStringList observerChoices();

// What a reader calls a light, an observer or a camera: "CIE 1931 2°" for "cie1931".
QString titleOf(const QString& name);
bool isCamera(const QString& observer);

}  // namespace cutis
