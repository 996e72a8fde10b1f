/*---------------------------------------------------------------------------*\
    capsuleFoam: elastic capsules and red blood cells for OpenFOAM
    Copyright (C) 2026 The capsuleFoam developers
-------------------------------------------------------------------------------
License
    This file is part of capsuleFoam, free software under the GNU General
    Public License, version 3 or later: see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "immersedInterface.H"
#include "hexMatcher.H"
#include "bitSet.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace capsule
{

template<class Type>
static tmp<GeometricField<Type, fvPatchField, volMesh>> zeroField
(
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dims
)
{
    return GeometricField<Type, fvPatchField, volMesh>::New
    (
        name,
        mesh,
        dimensioned<Type>(dims, Zero)
    );
}


//- Make the values of coupled patches those of the cells beyond them
template<class Type>
static void takeNeighbours(GeometricField<Type, fvPatchField, volMesh>& field)
{
    field.correctBoundaryConditions();
    for (fvPatchField<Type>& pf : field.boundaryFieldRef())
    {
        if (pf.coupled())
        {
            const Field<Type> neighbours(pf.patchNeighbourField());
            static_cast<Field<Type>&>(pf) = neighbours;
        }
    }
}

} // End namespace capsule
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::capsule::immersedInterface::checkCell(const label celli) const
{
    const fvMesh& mesh = levelSet_.mesh();

    if (!hexMatcher().isA(mesh, celli))
    {
        FatalErrorInFunction
            << "The membrane cuts cell " << celli << " at "
            << mesh.C()[celli] << ", which is not a hexahedron" << nl
            << "    Cells at a membrane must be orthogonal hexahedra."
            << exit(FatalError);
    }

    for (const label facei : mesh.cells()[celli])
    {
        const vector s = normalised(mesh.faceAreas()[facei]);
        const vector d =
            normalised(mesh.faceCentres()[facei] - mesh.cellCentres()[celli]);
        if (mag(s & d) < 1 - 1e-6)
        {
            FatalErrorInFunction
                << "The membrane cuts cell " << celli << " at "
                << mesh.C()[celli] << ", which is not orthogonal" << nl
                << "    Cells at a membrane must be orthogonal hexahedra."
                << exit(FatalError);
        }
    }
}


Foam::Pair<Foam::capsule::vector2> Foam::capsule::immersedInterface::ends
(
    const label facei
) const
{
    const fvMesh& mesh = levelSet_.mesh();
    const meshPlane& plane = levelSet_.plane();
    const face& f = mesh.faces()[facei];

    // The other end is the point of the face furthest from the first
    const vector2 a = plane(mesh.points()[f[0]]);
    vector2 b = a;
    for (const label pointi : f)
    {
        const vector2 c = plane(mesh.points()[pointi]);
        if ((c - a).norm() > (b - a).norm())
        {
            b = c;
        }
    }
    return Pair<vector2>(a, b);
}


void Foam::capsule::immersedInterface::addOnFace
(
    surfaceScalarField& field,
    const label facei,
    const scalar value
) const
{
    const polyBoundaryMesh& patches = levelSet_.mesh().boundaryMesh();
    if (facei < levelSet_.mesh().nInternalFaces())
    {
        field[facei] += value;
    }
    else
    {
        const label patchi = patches.whichPatch(facei);
        field.boundaryFieldRef()[patchi][facei - patches[patchi].start()] +=
            value;
    }
}


void Foam::capsule::immersedInterface::addFace
(
    const label facei,
    const label patchi,
    const label neighbour,
    const scalar sideP,
    const scalar sideN,
    const scalar weight,
    DynamicList<scalar>& alphas,
    DynamicList<scalar>& depths,
    DynamicList<scalar>& centreAlphas,
    DynamicList<scalar>& centreDepths
)
{
    const fvMesh& mesh = levelSet_.mesh();
    const label own = mesh.faceOwner()[facei];

    scalar alpha;
    const vector2 centre = levelSet_.plane()(mesh.faceCentres()[facei]);
    const scalar atCentre = levelSet_.signedDistance(centre, alpha);
    const scalar side = (sideP == sideN ? sideP : atCentre < 0 ? -1 : 1);

    if (sideP != sideN)
    {
        checkCell(own);
        views_.append
        ({
            own, neighbour, patchi, facei, 1, sideP, side == sideP, 1 - weight
        });
        views_.append
        ({
            patchi == -1 ? neighbour : -1, own, -1, facei, -1, sideN,
            side == sideN, weight
        });
        borrowed_.append(views_.size() - (side == sideP ? 1 : 2));
        centreAlphas.append(alpha);
        centreDepths.append(atCentre);
    }

    // From the centre to each end at most one crossing is looked for
    const Pair<vector2> ends(this->ends(facei));
    for (const vector2& end : ends)
    {
        const scalar atEnd = levelSet_.signedDistance(end, alpha);
        const bool centreBeyond = (atCentre*side < 0);
        const bool endBeyond = (atEnd*side < 0);
        if (!centreBeyond && !endBeyond)
        {
            continue;
        }

        scalar from = 0;
        scalar to = 1;
        if (centreBeyond != endBeyond)
        {
            // Regula falsi with halving (Illinois) on the signed distance
            scalar a = 0, b = 1, fa = atCentre, fb = atEnd, xi = 0;
            for (label iter = 0; iter < 30; ++iter)
            {
                xi = (a*fb - b*fa)/(fb - fa);
                const scalar f = levelSet_.signedDistance
                (
                    centre + xi*(end - centre), alpha
                );
                if (mag(f) < 1e-10*levelSet_.width())
                {
                    break;
                }
                if (f*fb < 0)
                {
                    a = b;
                    fa = fb;
                }
                else
                {
                    fa *= 0.5;
                }
                b = xi;
                fb = f;
            }
            (endBeyond ? from : to) = xi;
        }

        // Two-point Gauss rule; a half face has half of the face's weight
        for (const scalar gauss : {-1/Foam::sqrt(3.0), 1/Foam::sqrt(3.0)})
        {
            const scalar xi = 0.5*(from + to + gauss*(to - from));
            depths.append
            (
                levelSet_.signedDistance(centre + xi*(end - centre), alpha)
            );
            alphas.append(alpha);
            beyond_.append({facei, -0.25*(to - from)*side});
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::capsule::immersedInterface::immersedInterface
(
    const word& name,
    const fvMesh& mesh,
    const meshPlane& plane,
    const closedCurve& curve,
    const scalar bandWidth
)
:
    levelSet_(name, mesh, plane, curve, bandWidth),
    cells_(curve, levelSet_.alpha(), levelSet_.distance()),
    U_(zeroField<vector>("jumpU:" + name, mesh, dimVelocity)),
    p_(zeroField<scalar>("jumpp:" + name, mesh, dimPressure)),
    gradp_(zeroField<vector>("jumpGradp:" + name, mesh, dimPressure/dimLength))
{
    // Faces of cells that are closer to the membrane than a cell width
    const volScalarField& side = levelSet_.side();
    bitSet close(mesh.nFaces());
    forAll(levelSet_.cells(), i)
    {
        if (mag(levelSet_.distance()(i)) < 1.5*levelSet_.width())
        {
            for (const label facei : mesh.cells()[levelSet_.cells()[i]])
            {
                close.set(facei);
            }
        }
    }

    DynamicList<scalar> alphas;
    DynamicList<scalar> depths;
    DynamicList<scalar> centreAlphas;
    DynamicList<scalar> centreDepths;

    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        if (close[facei])
        {
            const label N = mesh.neighbour()[facei];
            addFace
            (
                facei, -1, N,
                side[mesh.owner()[facei]], side[N],
                mesh.weights()[facei],
                alphas, depths, centreAlphas, centreDepths
            );
        }
    }
    for (const fvPatch& patch : mesh.boundary())
    {
        if (!patch.coupled())
        {
            continue;
        }
        const label patchi = patch.index();
        const scalarField beyondPatch
        (
            side.boundaryField()[patchi].patchNeighbourField()
        );
        forAll(patch, i)
        {
            if (close[patch.start() + i])
            {
                addFace
                (
                    patch.start() + i, patchi, i,
                    side[patch.faceCells()[i]], beyondPatch[i],
                    mesh.weights().boundaryField()[patchi][i],
                    alphas, depths, centreAlphas, centreDepths
                );
            }
        }
    }

    cut_.resize(mesh.nCells());
    for (const view& v : views_)
    {
        if (v.cell != -1)
        {
            cut_.set(v.cell);
        }
    }
    cutVolume_ = 0;
    for (const label celli : cut_)
    {
        cutVolume_ += mesh.V()[celli];
    }
    reduce(cutVolume_, sumOp<scalar>());

    beyondPoints_.reset
    (
        new jumpConditions::targets
        (
            curve,
            Eigen::Map<const nodalScalars>(alphas.cdata(), alphas.size()),
            Eigen::Map<const nodalScalars>(depths.cdata(), depths.size())
        )
    );
    centres_.reset
    (
        new jumpConditions::targets
        (
            curve,
            Eigen::Map<const nodalScalars>
            (
                centreAlphas.cdata(), centreAlphas.size()
            ),
            Eigen::Map<const nodalScalars>
            (
                centreDepths.cdata(), centreDepths.size()
            )
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::capsule::immersedInterface::setJumps(const jumpConditions& jumps)
{
    const nodalVectors U = jumps.velocity(cells_);
    const nodalScalars p = jumps.pressure(cells_);
    const nodalVectors gradp = jumps.pressureGradient(cells_);

    forAll(levelSet_.cells(), i)
    {
        const label celli = levelSet_.cells()[i];
        U_[celli] = levelSet_.plane().toVector(U.row(i));
        p_[celli] = p(i);
        gradp_[celli] = levelSet_.plane().toVector(gradp.row(i));
    }
    takeNeighbours(U_);
    takeNeighbours(p_);
    takeNeighbours(gradp_);

    beyondU_ = jumps.velocity(*beyondPoints_);

    const Pair<nodalVectors> curvature
    (
        jumps.velocityCurvature(*centres_, 0),
        jumps.velocityCurvature(*centres_, 1)
    );
    const fvMesh& mesh = levelSet_.mesh();
    interpolationError_.resize(borrowed_.size());
    forAll(borrowed_, i)
    {
        const view& v = views_[borrowed_[i]];
        const vector2 S = levelSet_.plane()(onFace(mesh.Sf(), v.face));
        const label normal = (mag(S(0)) > mag(S(1)) ? 0 : 1);
        const scalar across = 1/onFace(mesh.nonOrthDeltaCoeffs(), v.face);
        const scalar along = S.norm()/levelSet_.plane().thickness();
        interpolationError_(i) =
            (S(normal) < 0 ? -1 : 1)
           *(
                0.5*v.weight*(1 - v.weight)*sqr(across)
               *curvature[normal](i, normal)
              - sqr(along)/24*curvature[1 - normal](i, normal)
            );
    }
}


Foam::vector Foam::capsule::immersedInterface::addLaplacian
(
    const scalar mu,
    volVectorField& source
) const
{
    const fvMesh& mesh = levelSet_.mesh();
    const surfaceScalarField& delta = mesh.nonOrthDeltaCoeffs();
    vector total(Zero);

    for (const view& v : views_)
    {
        if (v.cell != -1)
        {
            const vector flux =
                mu*onFace(delta, v.face)*onFace(mesh.magSf(), v.face)
               *v.side*seen(U_, v);
            source[v.cell] += flux/mesh.V()[v.cell];
            total += flux;
        }
    }
    return returnReduce(total, sumOp<vector>());
}


Foam::vector Foam::capsule::immersedInterface::addGradient
(
    volVectorField& gradient
) const
{
    const fvMesh& mesh = levelSet_.mesh();
    vector total(Zero);

    for (const view& v : views_)
    {
        if (v.cell != -1)
        {
            const vector flux =
                v.sign*onFace(mesh.Sf(), v.face)*v.weight*v.side*seen(p_, v);
            gradient[v.cell] += flux/mesh.V()[v.cell];
            total += flux;
        }
    }
    return returnReduce(total, sumOp<vector>());
}


void Foam::capsule::immersedInterface::addForce
(
    const vector& force,
    volVectorField& source
) const
{
    for (const label celli : cut_)
    {
        source[celli] += force/cutVolume_;
    }
}


void Foam::capsule::immersedInterface::addFlux
(
    surfaceScalarField& flux,
    surfaceScalarField& pressureFlux
) const
{
    const fvMesh& mesh = levelSet_.mesh();

    for (const view& v : views_)
    {
        if (v.ownsFlux)
        {
            const vector& S = onFace(mesh.Sf(), v.face);
            const vector U = v.weight*seen(U_, v);
            const vector gradp = v.weight*seen(gradp_, v);
            const scalar snGradp =
                v.sign*onFace(mesh.nonOrthDeltaCoeffs(), v.face)*seen(p_, v);

            addOnFace(flux, v.face, v.side*(U & S));
            addOnFace
            (
                pressureFlux,
                v.face,
                v.side*((gradp & S) - snGradp*mag(S))
            );
        }
    }

    forAll(beyond_, i)
    {
        const beyond& b = beyond_[i];
        const vector U = levelSet_.plane().toVector(beyondU_.row(i));
        addOnFace(flux, b.face, b.weight*(U & onFace(mesh.Sf(), b.face)));
    }
}


void Foam::capsule::immersedInterface::addDivergence
(
    volScalarField& divergence
) const
{
    const fvMesh& mesh = levelSet_.mesh();
    scalar total = 0;

    forAll(borrowed_, i)
    {
        const view& v = views_[borrowed_[i]];
        if (v.cell != -1)
        {
            const scalar flux =
               -v.sign*v.side*interpolationError_(i)
               *onFace(mesh.magSf(), v.face);
            divergence[v.cell] += flux/mesh.V()[v.cell];
            total += flux;
        }
    }

    // No net source: spread over the inside
    const volScalarField& side = levelSet_.side();
    scalar inside = 0;
    forAll(side, celli)
    {
        inside += (side[celli] < 0 ? mesh.V()[celli] : 0);
    }
    reduce(total, sumOp<scalar>());
    reduce(inside, sumOp<scalar>());
    forAll(side, celli)
    {
        if (side[celli] < 0)
        {
            divergence[celli] -= total/inside;
        }
    }
}
