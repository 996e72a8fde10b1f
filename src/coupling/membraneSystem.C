/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "membraneSystem.H"
#include "freeSpaceResponse.H"
#include "timeScheme.H"
#include "fvc.H"
#include "profiling.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

//- Vectors with their components stacked, and back
static nodalScalars stacked(const nodalVectors& v)
{
    return Eigen::Map<const nodalScalars>(v.data(), v.size());
}

static nodalVectors unstacked(const nodalScalars& v)
{
    return Eigen::Map<const nodalVectors>(v.data(), v.size()/2, 2);
}

//- Root mean square over the nodes
static scalar rms(const nodalVectors& v)
{
    return v.norm()/Foam::sqrt(scalar(v.rows()));
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::capsule::membraneSystem::resolvedWave_ = 1.6;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::capsule::membraneSystem::part::part
(
    const word& name,
    const dictionary& dict,
    const meshPlane& plane,
    const fvMesh& mesh,
    const scalar viscosity
)
:
    body(name, dict, plane, mesh),
    ratio(body.viscosity()/viscosity)
{}


void Foam::capsule::membraneSystem::checkInside
(
    const membrane& m,
    const nodalVectors& nodes
) const
{
    // Distance of the points to the boundary faces, against the cells' width
    const pointField points(plane_.toPoints(nodes));
    scalar nearest = GREAT;
    word patch;
    for (const fvPatch& pp : mesh_.boundary())
    {
        if (pp.coupled() || pp.size() == 0)
        {
            continue;
        }
        const vectorField normals(pp.nf());
        forAll(pp, i)
        {
            // How far the points are from the face's plane, beside the face
            const scalar reach = pp.magSf()[i]/plane_.thickness();
            for (const point& x : points)
            {
                const vector flat =
                    plane_.toVector(plane_(x - pp.Cf()[i]));
                const scalar depth = -(flat & normals[i]);
                if (mag(flat + depth*normals[i]) < reach && depth < nearest)
                {
                    nearest = depth;
                    patch = pp.name();
                }
            }
        }
    }
    reduce(nearest, minOp<scalar>());

    const boundBox& bounds = mesh_.bounds();
    bool outside = false;
    for (const point& x : points)
    {
        outside = outside || !bounds.contains(x);
    }

    const scalar width =
        Foam::sqrt(gMin(mesh_.V().field())/plane_.thickness());
    if (outside || nearest < width)
    {
        FatalIOErrorInFunction(*this)
            << "Membrane " << m.name() << " at time "
            << mesh_.time().timeName() << " is outside the mesh, or closer"
            << " than a cell width to its boundary " << patch << nl
            << "    Membranes must stay at least a cell width inside."
            << exit(FatalIOError);
    }
}


Foam::capsule::immersedInterface* Foam::capsule::membraneSystem::placed
(
    const membrane& m,
    const nodalVectors& nodes
) const
{
    checkInside(m, nodes);

    return new immersedInterface
    (
        m.name(),
        mesh_,
        plane_,
        closedCurve(m.basis(), nodes),
        oneSidedFit::radius
    );
}


Foam::capsule::nodalVectors Foam::capsule::membraneSystem::predicted
(
    const part& m
) const
{
    const membrane::state& last = m.body.old(0);
    const scalar dt = mesh_.time().deltaTValue();

    if (m.body.nOld() < 2)
    {
        return last.x + dt*last.velocity;
    }
    return last.x
      + dt/mesh_.time().deltaT0Value()*(last.x - m.body.old(1).x);
}


void Foam::capsule::membraneSystem::setResponse(part& m) const
{
    const closedCurve& curve = m.interface->distance().curve();
    const label n = 2*curve.size();
    const timeScheme scheme(mesh_, "ddt(membranes)", m.body.nOld());

    m.resolving = resolving(curve, m.interface->distance().width());
    m.velocity = freeSpaceResponse::velocity(curve, mu_);

    nodalMatrix derivative = 0.5*(1 + m.ratio)*nodalMatrix::Identity(n, n);
    if (m.ratio != 1)
    {
        m.traction = freeSpaceResponse::traction(curve);
        if (method_->usesResponse())
        {
            derivative -= (1 - m.ratio)*m.traction;
        }
    }
    if (method_->usesResponse() && method_->implicitStress())
    {
        derivative -= m.body.forceJacobian(curve)*m.velocity/scheme.c;
    }
    m.balance.compute(derivative);
}


Foam::capsule::nodalMatrix Foam::capsule::membraneSystem::resolving
(
    const closedCurve& curve,
    const scalar width
)
{
    return curve.basis().lowPass
    (
        resolvedWave_*curve.perimeter()
       /(constant::mathematical::twoPi*width)
    );
}


Foam::capsule::nodalVectors Foam::capsule::membraneSystem::resolved
(
    const closedCurve& curve,
    const nodalMatrix& resolving,
    const nodalVectors& f
)
{
    // Along normal and tangent, so that a uniform pressure is kept whole
    const nodalVectors& n = curve.normal();
    const nodalVectors& t = curve.tangent();

    return scaled(resolving*dot(f, n), n) + scaled(resolving*dot(f, t), t);
}


Foam::capsule::jumpConditions Foam::capsule::membraneSystem::jumps
(
    const immersedInterface& interface,
    const membrane::state& s
) const
{
    const closedCurve& curve = interface.distance().curve();

    return jumpConditions
    (
        curve,
        resolved
        (
            curve,
            resolving(curve, interface.distance().width()),
            s.force
        ),
        s.inertia,
        mu_
    );
}


void Foam::capsule::membraneSystem::setScale()
{
    scale_ = dimensionedScalar("one", dimless, 1);
    for (const part& m : parts_)
    {
        if (m.ratio != 1)
        {
            const volScalarField& side = m.interface->distance().side();
            forAll(side, celli)
            {
                if (side[celli] < 0)
                {
                    scale_[celli] = 1/m.ratio;
                }
            }
        }
    }
    scale_.correctBoundaryConditions();
}


void Foam::capsule::membraneSystem::setSwept()
{
    const timeScheme scheme(mesh_, "ddt(U)", U_.nOldTimes());
    if (scheme.c == 0)
    {
        return;
    }

    swept_ = dimensionedVector(swept_.dimensions(), Zero);
    const scalar weights[2] = {scheme.c0, -scheme.c00};

    for (const part& m : parts_)
    {
        const volScalarField& side = m.interface->distance().side();
        for (label level = 0; level < 2; ++level)
        {
            if (!m.old[level].valid() || weights[level] == 0)
            {
                continue;
            }

            // The old value as the new side of the cell saw it
            const volScalarField& old = m.old[level]->distance().side();
            forAll(side, celli)
            {
                if (side[celli] != old[celli])
                {
                    swept_[celli] +=
                        rho_*scale_[celli]*weights[level]*side[celli]
                       *m.old[level]->jumpU()[celli];
                }
            }
        }
    }
}


Foam::capsule::nodalVectors Foam::capsule::membraneSystem::velocity
(
    const closedCurve& curve,
    nodalVectors U
) const
{
    if (conserveArea_)
    {
        const scalar flux = curve.integral(dot(U, curve.normal()));
        U -= flux/curve.perimeter()*curve.normal();
    }
    return U;
}


Foam::capsule::nodalVectors Foam::capsule::membraneSystem::innerTraction
(
    const closedCurve& curve,
    const oneSidedFit::fitted& inner
) const
{
    const nodalVectors& n = curve.normal();
    nodalVectors traction = scaled(-inner.value.col(2), n);

    for (label i = 0; i < 2; ++i)
    {
        for (label j = 0; j < 2; ++j)
        {
            traction.col(i) +=
                mu_*n.col(j).cwiseProduct
                (
                    inner.gradient[j].col(i) + inner.gradient[i].col(j)
                );
        }
    }
    return traction;
}


void Foam::capsule::membraneSystem::setSources()
{
    sources_.clear();
    for (part& m : parts_)
    {
        const membrane::state& now = m.body.now();
        const closedCurve& curve = m.interface->distance().curve();
        m.interface->setJumps
        (
            jumpConditions
            (
                curve,
                resolved(curve, m.resolving, now.force),
                now.inertia,
                mu_
            )
        );
        m.interface->addLaplacian(mu_, sources_.momentum);
        m.interface->addGradient(sources_.gradient);
        m.interface->addFlux(sources_.flux, sources_.pressureFlux);
    }
    sources_.momentum += swept_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::membraneSystem::membraneSystem
(
    volVectorField& U,
    volScalarField& p,
    const dimensionedScalar& rho,
    const dimensionedScalar& mu
)
:
    IOdictionary
    (
        IOobject
        (
            "membraneProperties",
            U.time().constant(),
            U.mesh(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    mesh_(U.mesh()),
    plane_(mesh_),
    U_(U),
    p_(p),
    rho_(rho.value()),
    mu_(mu.value()),
    method_(couplingMethod::New(subDict("coupling"))),
    stressTolerance_
    (
        subDict("coupling").getCheckOrDefault<scalar>
        (
            "stressTolerance", 1e-3, scalarMinMax(VSMALL, 1)
        )
    ),
    displacementTolerance_
    (
        subDict("coupling").getCheckOrDefault<scalar>
        (
            "displacementTolerance", 1e-4, scalarMinMax(VSMALL, 1)
        )
    ),
    maxIter_
    (
        subDict("coupling").getCheckOrDefault<label>
        (
            "maxIter", 30, labelMinMax::ge(1)
        )
    ),
    conserveArea_
    (
        subDict("coupling").getOrDefault<bool>("conserveArea", true)
    ),
    scale_
    (
        IOobject("viscosityScale", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("one", dimless, 1)
    ),
    sources_(mesh_),
    swept_
    (
        IOobject("sweptMomentum", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimPressure/dimLength, Zero)
    ),
    iter_(0),
    converged_(true)
{
    // Wrong time schemes stop here, before the first step
    timeScheme(mesh_, "ddt(U)", 0);
    if (timeScheme(mesh_, "ddt(membranes)", 0).c == 0)
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "Entry ddt(membranes) is steadyState; permitted: Euler,"
            << " backward" << exit(FatalIOError);
    }

    const dictionary& dict = subDict("membranes");
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << e.keyword() << " is not a dictionary; membranes"
                << " holds one dictionary for each membrane"
                << exit(FatalIOError);
        }
        parts_.append(new part(e.keyword(), e.dict(), plane_, mesh_, mu_));
    }

    for (part& m : parts_)
    {
        const membrane::state& now = m.body.now();
        m.interface.reset(placed(m.body, now.interface));
        m.interface->setJumps(jumps(*m.interface, now));
        if (m.body.nOld() > 0)
        {
            m.old[0].reset(placed(m.body, m.body.old(0).interface));
            m.old[0]->setJumps(jumps(*m.old[0], m.body.old(0)));
        }
        else
        {
            // No velocity yet but that of the initial field
            oneSidedFit fit(*m.interface);
            m.body.now().velocity = fit(U_, nullptr).value;
        }
    }
    setScale();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::membraneSystem::predict()
{
    addProfiling(predict, "capsule::membraneSystem::predict");

    label unknowns = 0;
    for (part& m : parts_)
    {
        membrane& body = m.body;
        body.store();
        const closedCurve ahead(body.basis(), predicted(m));
        const nodalVectors nodes =
            resolving(ahead, m.interface->distance().width())*ahead.nodes();

        m.old[1].reset(m.old[0].release());
        m.old[0].reset(m.interface.release());
        m.interface.reset(placed(body, nodes));
        m.fit.reset(new oneSidedFit(*m.interface));

        membrane::state& now = body.now();
        now.interface = nodes;
        now.x = nodes;
        if (body.nOld() == 2)
        {
            const scalar ratio =
                mesh_.time().deltaTValue()/mesh_.time().deltaT0Value();
            now.force += ratio*(body.old(0).force - body.old(1).force);
        }
        const closedCurve& curve = m.interface->distance().curve();
        m.explicitForce = body.force(curve, curve.metric());
        setResponse(m);
        unknowns += now.force.size();
    }

    setScale();
    setSwept();

    force_.resize(unknowns);
    label start = 0;
    for (const part& m : parts_)
    {
        const nodalVectors& f = m.body.now().force;
        force_.segment(start, f.size()) = stacked(f);
        start += f.size();
    }

    method_->start();
    iter_ = 0;
    converged_ = false;
}


bool Foam::capsule::membraneSystem::loop()
{
    if (size() == 0)
    {
        // One solution of the fluid alone
        return iter_++ == 0;
    }

    if (converged_ || iter_ == maxIter_)
    {
        Info<< "Membranes: " << (converged_ ? "converged" : "NOT converged")
            << " in " << iter_ << " iterations" << endl;
        return false;
    }

    ++iter_;
    setSources();
    return true;
}


void Foam::capsule::membraneSystem::correct()
{
    addProfiling(correct, "capsule::membraneSystem::correct");

    nodalScalars step(force_.size());
    scalar stress = 0;
    scalar displacement = 0;
    label start = 0;

    for (part& m : parts_)
    {
        const closedCurve& curve = m.interface->distance().curve();
        membrane::state& now = m.body.now();
        const timeScheme scheme(mesh_, "ddt(membranes)", m.body.nOld());

        // Move with the fluid
        const oneSidedFit::fitted inner =
            (*m.fit)(U_, m.ratio != 1 ? &p_ : nullptr);
        const nodalScalars unresolved =
            stacked(now.force - resolved(curve, m.resolving, now.force));
        now.velocity = velocity
        (
            curve,
            inner.value.leftCols(2) + unstacked(m.velocity*unresolved)
        );
        now.x = scheme.c0*m.body.old(0).x + now.velocity;
        if (scheme.c00 != 0)
        {
            now.x -= scheme.c00*m.body.old(1).x;
        }
        now.x /= scheme.c;

        closedCurve moved(m.body.basis(), now.x);
        if (conserveArea_)
        {
            // What the time scheme leaves
            now.x +=
                (m.body.referenceArea() - moved.area())/moved.perimeter()
               *moved.normal();
            moved = closedCurve(m.body.basis(), now.x);
        }

        // Balance of stress
        const nodalVectors F =
            method_->implicitStress()
          ? m.body.force(moved, curve.metric())
          : m.explicitForce;
        nodalVectors balance = F - now.force;
        if (m.ratio != 1)
        {
            balance +=
                (1 - m.ratio)
               *(
                    innerTraction(curve, inner)
                  + unstacked(m.traction*unresolved + 0.5*unresolved)
                );
        }
        const nodalScalars change = m.balance.solve(stacked(balance));
        step.segment(start, change.size()) = change;
        start += change.size();

        const scalar scale =
            rms(F)
          + 0.5*(1 + m.ratio)*mu_*rms(curve.ds(now.velocity))
          + VSMALL;
        stress = max(stress, rms(unstacked(change))/scale);
        displacement = max
        (
            displacement,
            unstacked(m.velocity*change).rowwise().norm().maxCoeff()
           /(scheme.c*m.interface->distance().width())
        );
    }

    Info<< "Membranes: iteration " << iter_ << ", imbalance of stress "
        << stress << ", displacement " << displacement << " cell widths"
        << endl;

    converged_ =
        stress < stressTolerance_ && displacement < displacementTolerance_;

    if (!converged_ && iter_ < maxIter_)
    {
        force_ = method_->next(force_, step);
        start = 0;
        for (part& m : parts_)
        {
            nodalVectors& f = m.body.now().force;
            f = unstacked(force_.segment(start, f.size()));
            start += f.size();
        }
    }
}


void Foam::capsule::membraneSystem::write() const
{
    if (mesh_.time().writeTime())
    {
        for (const part& m : parts_)
        {
            m.body.write(mesh_.time());
            m.body.writeCloud(mesh_);
            m.interface->distance().field()().write();
        }
    }
}
