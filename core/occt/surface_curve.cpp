#include "osculate/occt/surface_curve.h"

#include <optional>

#include <Adaptor3d_CurveOnSurface.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomLib.hxx>
#include <Geom_BoundedSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SweptSurface.hxx>

#include "osculate/occt/space_curve.h"

namespace osculate {

namespace {

Handle(Geom_Surface) untrimmed(Handle(Geom_Surface) surface) {
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) {
    surface = trimmed->BasisSurface();
  }
  return surface;
}

Handle(Geom2d_Curve) untrimmed(Handle(Geom2d_Curve) curve) {
  while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve)) {
    curve = trimmed->BasisCurve();
  }
  return curve;
}

/// Whether the surface gives its isoparametric lines exactly: offset surfaces approximate them.
bool hasExactIsoLines(const Geom_Surface& surface) {
  return dynamic_cast<const Geom_ElementarySurface*>(&surface) != nullptr ||
         dynamic_cast<const Geom_SweptSurface*>(&surface) != nullptr ||
         dynamic_cast<const Geom_BoundedSurface*>(&surface) != nullptr;
}

/// The isoparametric line that a straight pcurve along u or v runs on, with the pcurve's own
/// parameter; empty for another pcurve or surface.
std::optional<EdgeCurve> convertIsoLine(const Geom2d_Curve& pcurve, const Geom_Surface& surface,
                                        double first, double last) {
  const auto* line = dynamic_cast<const Geom2d_Line*>(&pcurve);
  if (line == nullptr || !hasExactIsoLines(surface)) return {};
  const gp_Pnt2d origin = line->Location();
  const gp_Dir2d direction = line->Direction();
  const bool alongU = direction.Y() == 0.0;
  if (!alongU && direction.X() != 0.0) return {};
  const double start = alongU ? origin.X() : origin.Y();
  const double speed = alongU ? direction.X() : direction.Y();  // 1 or -1
  const double from = start + speed * first;
  const double to = start + speed * last;
  const Handle(Geom_Curve) iso = alongU ? surface.VIso(origin.Y()) : surface.UIso(origin.X());
  EdgeCurve result = convertCurve(iso, std::min(from, to), std::max(from, to));
  if (speed < 0.0) result.curve = result.curve.reversed();
  result.curve = result.curve.reparametrised(first, last);
  return result;
}

}  // namespace

EdgeCurve convertSurfaceCurve(const opencascade::handle<Geom2d_Curve>& pcurve,
                              const opencascade::handle<Geom_Surface>& surface, double first,
                              double last) {
  const Handle(Geom2d_Curve) bareCurve = untrimmed(pcurve);
  const Handle(Geom_Surface) bareSurface = untrimmed(surface);
  if (const auto plane = Handle(Geom_Plane)::DownCast(bareSurface)) {
    return convertCurve(GeomLib::To3d(plane->Position().Ax2(), bareCurve), first, last);
  }
  if (auto iso = convertIsoLine(*bareCurve, *bareSurface, first, last)) return *iso;
  const Adaptor3d_CurveOnSurface adaptor(new Geom2dAdaptor_Curve(bareCurve, first, last),
                                         new GeomAdaptor_Surface(bareSurface));
  return fitAdaptor(adaptor, first, last);
}

}  // namespace osculate
