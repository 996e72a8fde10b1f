/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneSystem.H"
#include "membraneNames.H"
#include "placedShape.H"
#include "timeScheme.H"
#include "sigFpe.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Kind and name of a membrane or body, in a sentence and at its start
static Foam::string called(const Foam::capsule::immersedBody& part)
{
    return part.kind() + " " + part.name();
}

static Foam::string titled(const Foam::capsule::immersedBody& part)
{
    Foam::string title(called(part));
    title[0] = std::toupper(title[0]);
    return title;
}

//- Warn of a membrane that does not keep its area as its law promises
static void warnOfStrain
(
    const Foam::capsule::membrane& m,
    const Foam::capsule::closedSurface& surface
)
{
    using namespace Foam;

    const scalar permitted = m.largestStrain();
    if (permitted > 1)
    {
        return;
    }
    const capsule::membraneMechanics::principalValues p = m.principal(surface);
    const scalar strain = (p.l1.array()*p.l2.array() - 1).abs().maxCoeff();
    if (strain > permitted)
    {
        WarningInFunction
            << "Membrane " << m.name() << " has changed its area locally by "
            << strain << ", in the plane its length, more than the "
            << permitted << " of its elastic law's entry largestStrain: an"
            << " areaModulus " << strain/permitted << " times as large keeps it"
            << endl;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::capsule::membraneSystem::obstacle
(
    const label i,
    const List<surfaceSamples>& samples,
    const scalar cells
) const
{
    const string boundary = clearance_->obstacle(samples[i].points(), cells);
    if (!boundary.empty())
    {
        return boundary;
    }
    for (label j = 0; j < i; ++j)
    {
        if
        (
            clearance_->meet
            (
                samples[i], samples[j], cells, nesting_.nested(i, j)
            )
        )
        {
            return called(parts_[j]);
        }
    }
    return string::null;
}


Foam::string Foam::capsule::membraneSystem::predictedObstacle() const
{
    const Time& time = mesh_.time();
    List<surfaceSamples> samples(parts_.size());
    forAll(parts_, i)
    {
        samples[i] = clearance_->samples
        (
            closedSurface
            (
                parts_[i].basis(),
                parts_[i].predicted(time.deltaTValue(), time.deltaT0Value())
            )
        );
        const string near = obstacle(i, samples, clearance::least);
        if (!near.empty())
        {
            return
                called(parts_[i]) + " comes closer than "
              + Foam::name(clearance::least) + " cell widths to " + near;
        }
    }
    return string::null;
}


void Foam::capsule::membraneSystem::warnOfResolution() const
{
    List<surfaceSamples> samples(parts_.size());
    forAll(parts_, i)
    {
        const string name = called(parts_[i]);
        const closedSurface surface(parts_[i].presentSurface());
        samples[i] = clearance_->samples(surface);
        const string near = obstacle(i, samples, clearance::resolved);
        if (!near.empty())
        {
            WarningInFunction
                << titled(parts_[i]).c_str() << " is closer than "
                << clearance::resolved << " cell widths to " << near.c_str()
                << ": the film there is not resolved" << endl;
        }
        solvedVector where;
        const scalar film = clearance_->film(surface, where);
        if (film < clearance::resolved)
        {
            WarningInFunction
                << "Two parts of " << name.c_str() << " are " << film
                << " cell widths apart at " << directions_.toPoint(where)
                << ", less than " << clearance::resolved
                << ": it is too thin there, or folded too closely, to be"
                << " resolved" << endl;
        }
        const scalar spacing = clearance_->spacing(surface);
        if (spacing > placedShape::widestSpacing)
        {
            WarningInFunction
                << "Points of " << name.c_str() << " are " << spacing
                << " cell widths apart, more than "
                << placedShape::widestSpacing
                << ": it is not resolved there; see its entry "
                << (directions_.spatial() ? "degree" : "points") << endl;
        }
        if (i < nMembranes_)
        {
            warnOfStrain((*this)[i], surface);
        }
        warnOfMomentumLayer(parts_[i]);
    }
}


void Foam::capsule::membraneSystem::warnOfMomentumLayer
(
    const immersedBody& part
) const
{
    const scalar thickness = part.momentumThickness();
    if (thickness < clearance::resolved)
    {
        WarningInFunction
            << "The motion of " << called(part).c_str()
            << " changes so fast that its momentum spreads over " << thickness
            << " cell widths of the thinner liquid, less than "
            << clearance::resolved << ": this layer, and the damping by it, are"
            << " not resolved" << endl;
    }
}


void Foam::capsule::membraneSystem::readMembranes()
{
    const dictionary& dict = input::subDict(*this, "membranes");
    if (dict.size())
    {
        clearance_.reset(new clearance(mesh_, directions_));
    }
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << e.keyword() << " is not a dictionary; membranes"
                << " holds one dictionary for each membrane"
                << exit(FatalIOError);
        }
        parts_.append
        (
            immersedMembrane::New
            (
                subDict("coupling"),
                e.keyword(),
                e.dict(),
                directions_,
                mesh_,
                rho_,
                mu_
            )
        );
        ++nMembranes_;
    }
}


void Foam::capsule::membraneSystem::nest()
{
    List<surfaceSamples> samples(parts_.size());
    forAll(parts_, i)
    {
        samples[i] = clearance_->samples(parts_[i].presentSurface());
    }
    nesting_ = nesting(*clearance_, samples);
    const labelList newPlace(nesting_.sort());
    parts_.reorder(newPlace);
    inplaceReorder(newPlace, samples);

    forAll(parts_, i)
    {
        const dictionary& dict = subDict("membranes").subDict(parts_[i].name());
        if (nesting_.outer(i) >= 0)
        {
            if (dict.found("load"))
            {
                FatalIOErrorInFunction(dict)
                    << titled(parts_[i]).c_str() << " lies inside "
                    << called(parts_[nesting_.outer(i)]).c_str()
                    << " and has an entry load; permitted there: none"
                    << exit(FatalIOError);
            }
            parts_[i].setOuter(parts_[nesting_.outer(i)]);
        }
        const string near = obstacle(i, samples, clearance::least);
        if (!near.empty())
        {
            FatalIOErrorInFunction(dict)
                << titled(parts_[i]).c_str() << " touches or crosses "
                << near.c_str() << nl
                << "    Membranes must lie inside the mesh, at least "
                << clearance::least << " cell widths from its boundaries and"
                << " from each other; see the entries "
                << flatOutput(dict.subDict("shape").toc()) << " of shape"
                << exit(FatalIOError);
        }
    }
}


void Foam::capsule::membraneSystem::setResidual()
{
    UPtrList<interfaceResidual> residuals(size());
    UPtrList<immersedBody> bodies(size());
    forAll(parts_, i)
    {
        residuals.set(i, &parts_[i]);
        bodies.set(i, &parts_[i]);
    }
    contact_ = contact::New(*this, mesh_, directions_);
    if (contact_.valid())
    {
        contactResidual_.reset
        (
            new contactResidual(*contact_, residuals, bodies)
        );
    }
    else
    {
        residual_.reset(new combinedResidual(residuals));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneSystem::fields::fields(const fvMesh& mesh)
:
    scale
    (
        IOobject("viscosityScale", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    ),
    sources(mesh),
    freshCells
    (
        IOobject("freshCellMomentum", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimPressure/dimLength, Zero)
    )
{}


Foam::capsule::membraneSystem::membraneSystem
(
    volVectorField& U,
    volScalarField& pressure,
    const dimensionedScalar& rho,
    const dimensionedScalar& mu,
    const drivingForce& driving
)
:
    IOdictionary
    (
        // Until the file is read: a number beyond the range of a scalar is an
        // error of the file, not a floating-point exception
        (
            sigFpe::ignore(),
            IOobject
            (
                "membraneProperties",
                U.time().constant(),
                U.mesh(),
                IOobject::MUST_READ_IF_MODIFIED,
                IOobject::NO_WRITE
            )
        )
    ),
    mesh_(U.mesh()),
    directions_(mesh_),
    U_(U),
    pressure_(pressure),
    rho_(rho.value()),
    mu_(mu.value()),
    driving_(driving),
    nMembranes_(0),
    method_
    (
        // Wrong names may have taken the rest of the file with them
        (
            membraneNames::check(*this),
            couplingMethod::New(input::subDict(*this, "coupling"))
        )
    ),
    stressTolerance_
    (
        input::getBetweenOrDefault<scalar>
        (
            subDict("coupling"), "stressTolerance", 1e-3, 1e-15, 1
        )
    ),
    displacementTolerance_
    (
        input::getBetweenOrDefault<scalar>
        (
            subDict("coupling"), "displacementTolerance", 1e-4, 1e-15, 1
        )
    ),
    maxIter_
    (
        input::getBetweenOrDefault<label>
        (
            subDict("coupling"), "maxIter", 30, 1, 10000
        )
    ),
    iter_(0),
    converged_(true),
    nMoved_(0),
    placed_(false)
{
    // Wrong time schemes stop here, before the first step
    input::warnOfOthers
    (
        mesh_.schemesDict().subDict("ddtSchemes"),
        {"default", "ddt(U)", "ddt(membranes)"}
    );
    timeScheme(mesh_, "ddt(U)", 0);
    if (timeScheme(mesh_, "ddt(membranes)", 0).c == 0)
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "Entry ddt(membranes) is steadyState; permitted: Euler,"
            << " backward" << exit(FatalIOError);
    }

    readMembranes();
    if (size())
    {
        nest();
        fields_.reset(new fields(mesh_));

        setResidual();
    }
    bool scaled = false;
    for (immersedBody& m : parts_)
    {
        m.start(U_);
        scaled = scaled || m.scale() != 1;
        if (m.smeared())
        {
            fields_->sources.viscosity.reset
            (
                new volScalarField
                (
                    IOobject("viscosity", mesh_.time().timeName(), mesh_),
                    mesh_,
                    dimensionedScalar(dimPressure*dimTime, Zero)
                )
            );
        }
    }
    if (size())
    {
        setScale();
    }
    if (scaled)
    {
        scaledPressure_.reset(new volScalarField("pScaled", pressure));
        *scaledPressure_ *= fields_->scale;
        addDriven(*scaledPressure_, false);
    }
}
