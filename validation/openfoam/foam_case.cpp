// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/foam_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "validation/openfoam/foam_text.hpp"

namespace wetdeck {
namespace {

constexpr double temperature = 300;  // [K]; no law asks for it

const std::map<std::string, std::string> patch_types{
    {"walls", "wall"},   {"body", "wall"}, {"symmetry", "symmetryPlane"},
    {"inflow", "patch"}, {"far", "patch"}, {"atmosphere", "patch"}};

/// The conditions of a field on the patches of the mesh.
std::string conditions(const FoamCase& wanted, const std::map<std::string, std::string>& of_patch) {
    std::set<std::string> names;
    for (const PlaneMesh::Side& side : wanted.mesh.boundary) names.insert(side.patch);
    std::string text = "boundaryField\n{\n    sides { type empty; }\n";
    for (const std::string& name : names)
        text += fmt::format("    {} {{ {} }}\n", name,
                            name == "symmetry" ? "type symmetryPlane;" : of_patch.at(name));
    return text + "}\n";
}

std::string field(const FoamCase& wanted, const std::string& name, const std::string& dimensions,
                  const std::string& inside, const std::map<std::string, std::string>& of_patch) {
    return foam_head(name == "U" ? "volVectorField" : "volScalarField", name) +
           fmt::format("dimensions [{}];\ninternalField {};\n", dimensions, inside) +
           conditions(wanted, of_patch);
}

std::map<std::string, std::string> fields(const FoamCase& wanted) {
    const std::string stream = "uniform " + foam_vector(wanted.stream);
    const std::string rest = fmt::format("uniform {:.15g}", wanted.compressible ? wanted.air_pressure : 0.0);
    const std::string gradient = "type zeroGradient;";
    const std::string wall_pressure = fmt::format("type fixedFluxPressure; value {};", rest);
    std::map<std::string, std::string> files;
    files["0/U"] = field(wanted, "U", "0 1 -1 0 0 0 0", stream,
                         {{"walls", "type slip;"},
                          {"body", "type slip;"},
                          {"inflow", "type fixedValue; value " + stream + ";"},
                          {"far", "type fixedValue; value " + stream + ";"},
                          {"atmosphere", "type pressureInletOutletVelocity; value " + stream + ";"}});
    files["0/p_rgh"] =
        field(wanted, "p_rgh", "1 -1 -2 0 0 0 0", rest,
              {{"walls", wall_pressure},
               {"body", wall_pressure},
               {"inflow", wall_pressure},
               {"far", wall_pressure},
               {"atmosphere", wanted.compressible
                                  ? fmt::format("type fixedValue; value {};", rest)
                                  : fmt::format("type totalPressure; p0 {}; value {};", rest, rest)}});
    files["0/alpha.water"] = field(
        wanted, "alpha.water", "0 0 0 0 0 0 0", foam_scalars(shares_in(wanted.mesh, wanted.water_boxes)),
        {{"walls", gradient},
         {"body", gradient},
         {"inflow", "type fixedValue; value uniform 1;"},
         {"far", gradient},
         {"atmosphere", "type inletOutlet; inletValue uniform 0; value uniform 0;"}});
    if (!wanted.compressible) return files;
    const std::string calculated = fmt::format("type calculated; value {};", rest);
    const std::string warm = fmt::format("uniform {}", temperature);
    std::map<std::string, std::string> pressure, heat;
    for (const auto& [name, type] : patch_types) {
        pressure[name] = calculated;
        heat[name] = name == "inflow" ? fmt::format("type fixedValue; value {};", warm) : gradient;
    }
    heat["atmosphere"] = fmt::format("type inletOutlet; inletValue {}; value {};", warm, warm);
    files["0/p"] = field(wanted, "p", "1 -1 -2 0 0 0 0", rest, pressure);
    files["0/T"] = field(wanted, "T", "0 0 0 1 0 0 0", warm, heat);
    return files;
}

/// The barotropic law of Tait, rho = rho0 ((p + B)/(p0 + B))^(1/gamma), with B = 0 that of a gas without
/// losses: the laws of this program. The heat capacity is so large that the temperature, which the law does
/// not ask for, stays what it is: near the edge of a plate the equation of the temperature otherwise ends
/// below zero.
std::string thermophysics(const std::string& phase, const FoamPhase& of, double pressure) {
    const double coefficient = of.density * of.sound_speed * of.sound_speed / of.exponent - pressure;
    return foam_head("dictionary", "thermophysicalProperties." + phase) +
           fmt::format(
               "thermoType\n{{\n    type heRhoThermo; mixture pureMixture; transport const; thermo hConst;\n"
               "    equationOfState adiabaticPerfectFluid; specie specie; energy "
               "sensibleInternalEnergy;\n}}\n"
               "mixture\n{{\n    specie {{ molWeight 18; }}\n    equationOfState {{ p0 {:.12g}; rho0 "
               "{:.12g}; B "
               "{:.12g}; gamma {:.12g}; }}\n    thermodynamics {{ Cp 1e7; Hf 0; }}\n    transport {{ mu "
               "{:.12g}; Pr 1e6; }}\n}}\n",
               pressure, of.density, std::abs(coefficient) < 1e-6 * pressure ? 0 : coefficient, of.exponent,
               of.viscosity);
}

std::map<std::string, std::string> materials(const FoamCase& wanted) {
    std::map<std::string, std::string> files;
    files["constant/g"] =
        foam_head("uniformDimensionedVectorField", "g") +
        fmt::format("dimensions [0 1 -2 0 0 0 0];\nvalue {};\n", foam_vector(wanted.gravity));
    files["constant/turbulenceProperties"] =
        foam_head("dictionary", "turbulenceProperties") + "simulationType laminar;\n";
    if (!wanted.compressible) {
        const auto phase = [](const FoamPhase& of) {
            return fmt::format("{{ transportModel Newtonian; nu {:.12g}; rho {:.12g}; }}\n",
                               of.viscosity / of.density, of.density);
        };
        files["constant/transportProperties"] = foam_head("dictionary", "transportProperties") +
                                                "phases (water air);\nwater " + phase(wanted.water) + "air " +
                                                phase(wanted.air) + "sigma 0;\n";
        return files;
    }
    files["constant/hRef"] = foam_head("uniformDimensionedScalarField", "hRef") +
                             fmt::format("dimensions [0 1 0 0 0 0 0];\nvalue {:.15g};\n", wanted.level);
    files["constant/thermophysicalProperties"] =
        foam_head("dictionary", "thermophysicalProperties") +
        fmt::format("phases (water air);\npMin {:.9g};\nsigma 0;\n", 1e-3 * wanted.air_pressure);
    files["constant/thermophysicalProperties.water"] =
        thermophysics("water", wanted.water, wanted.air_pressure);
    files["constant/thermophysicalProperties.air"] = thermophysics("air", wanted.air, wanted.air_pressure);
    return files;
}

std::string functions(const FoamCase& wanted) {
    std::string text;
    if (wanted.has_body)
        text += fmt::format(
            "    body\n    {{\n        type forces; libs (\"libforces.so\"); patches (body); CofR {};\n"
            "        writeControl timeStep; writeInterval 1; log no;\n    }}\n",
            foam_vector(wanted.moment_centre));
    for (const FoamProbes& probes : wanted.probes) {
        text += fmt::format(
            "    {}\n    {{\n        type probes; libs (\"libsampling.so\"); fields ({}); "
            "writeControl {};\n        probeLocations\n        (\n",
            probes.name, probes.fields,
            probes.interval > 0 ? fmt::format("runTime; writeInterval {:.9g}", probes.interval)
                                : "timeStep; writeInterval 1");
        for (const Vec2& p : probes.points) text += "            " + foam_vector(p, 0.5 * foam_layer) + "\n";
        text += "        );\n    }\n";
    }
    return text;
}

std::string control(const FoamCase& wanted) {
    return foam_head("dictionary", "controlDict") +
           fmt::format(
               "application {};\nstartFrom startTime;\nstartTime 0;\nstopAt endTime;\nendTime "
               "{:.12g};\ndeltaT "
               "{:.6g};\nwriteControl adjustableRunTime;\nwriteInterval {:.9g};\npurgeWrite 0;\nwriteFormat "
               "ascii;\n"
               "writePrecision 10;\nwriteCompression off;\ntimeFormat general;\ntimePrecision "
               "10;\nrunTimeModifiable no;\nadjustTimeStep yes;\nmaxCo {};\nmaxAlphaCo {};\nmaxDeltaT "
               "{:.6g};\n"
               "functions\n{{\n{}}}\n",
               wanted.solver(), wanted.end_time, 0.05 * wanted.largest_step, wanted.field_interval,
               wanted.courant_number, wanted.courant_number, wanted.largest_step, functions(wanted));
}

std::string schemes() {
    return foam_head("dictionary", "fvSchemes") +
           "ddtSchemes { default Euler; }\ngradSchemes { default Gauss linear; }\ndivSchemes\n{\n"
           "    default Gauss linear;\n"
           "    div(rhoPhi,U) Gauss linearUpwind grad(U);\n    div(phi,alpha) Gauss vanLeer;\n"
           "    div(phirb,alpha) Gauss linear;\n    div(rhoPhi,T) Gauss upwind;\n    div(rhoPhi,K) Gauss "
           "upwind;\n"
           "    div(phi,p) Gauss upwind;\n    div(phi,thermo:rho.water) Gauss upwind;\n    "
           "div(phi,thermo:rho.air) "
           "Gauss upwind;\n"
           "}\nlaplacianSchemes { default Gauss linear corrected; }\n"
           "interpolationSchemes { default linear; }\nsnGradSchemes { default corrected; }\n";
}

std::string solution(const FoamCase& wanted) {
    const std::string reference = wanted.reference
                                      ? fmt::format("    pRefPoint {};\n    pRefValue 0;\n",
                                                    foam_vector(*wanted.reference, 0.5 * foam_layer))
                                      : "";
    return foam_head("dictionary", "fvSolution") +
           fmt::format(
               "solvers\n{{\n    \"alpha.water.*\" {{ nAlphaCorr 2; nAlphaSubCycles 1; cAlpha 1; MULESCorr "
               "yes; "
               "nLimiterIter 5; solver smoothSolver; smoother symGaussSeidel; tolerance 1e-10; relTol 0; }}\n"
               "    \"pcorr.*\" {{ solver PCG; preconditioner DIC; tolerance 1e-6; relTol 0; }}\n"
               "    \"rho.*\" {{ solver diagonal; }}\n"
               "    p_rgh {{ solver GAMG; smoother {}; tolerance 1e-8; relTol 0.01; }}\n"
               "    p_rghFinal {{ $p_rgh; tolerance 1e-8; relTol 0; }}\n"
               "    \"(U|T).*\" {{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-6; relTol 0; "
               "maxIter "
               "20; }}\n}}\n"
               "PIMPLE\n{{\n    momentumPredictor no;\n    transonic no;\n    nOuterCorrectors 1;\n    "
               "nCorrectors 3;\n"
               "    nNonOrthogonalCorrectors {};\n{}}}\n",
               wanted.compressible ? "GaussSeidel" : "DIC", wanted.slanted_correctors, reference);
}

std::string script(const FoamCase& wanted) {
    return fmt::format(
        "#!/bin/sh\n# Runs the case from its start: results of an earlier run are removed.\n"
        "cd \"$(dirname \"$0\")\" || exit 4\n"
        "export WM_PROJECT_DIR=\"${{WM_PROJECT_DIR:-/usr/share/openfoam}}\"\n"
        "if ! command -v {0} > /dev/null; then\n"
        "    echo \"{0} is not installed: apt install openfoam, or load your own OpenFOAM first\" >&2\n    "
        "exit 4\nfi\n"
        "rm -rf postProcessing log.{0}\nfor time in [0-9]*; do\n    [ \"$time\" = 0 ] || rm -rf "
        "\"$time\"\ndone\n"
        "{0} > log.{0} 2>&1\nstatus=$?\n[ $status = 0 ] || tail -n 5 log.{0} >&2\nexit $status\n",
        wanted.solver());
}

}  // namespace

std::map<std::string, std::string> foam_files(const FoamCase& wanted, double layer) {
    std::map<std::string, std::string> files = fields(wanted);
    files.merge(materials(wanted));
    for (auto& [name, text] : poly_mesh_files(wanted.mesh, layer, patch_types))
        files["constant/polyMesh/" + name] = std::move(text);
    files["system/controlDict"] = control(wanted);
    files["system/fvSchemes"] = schemes();
    files["system/fvSolution"] = solution(wanted);
    files["run.sh"] = script(wanted);
    if (!wanted.geometry.empty()) files["section.geo"] = wanted.geometry;
    return files;
}

}  // namespace wetdeck
