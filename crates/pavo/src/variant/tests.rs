//! What the grammar of variants reads and refuses.

use super::{Fit, FittedForm, FresnelForm, Variant};

#[test]
fn variants_are_read_and_written_back() {
    let cases = [
        ("series:m=3,fit=xyz-gauss", Variant::Series { order: 3, fit: Fit::XyzGauss }),
        ("series:fit=xyz-gauss,m=5", Variant::Series { order: 5, fit: Fit::XyzGauss }),
        ("series:m=2,fit=shared-gauss-4", Variant::Series { order: 2, fit: Fit::SharedGaussians(4) }),
        ("series:m=2,fit=rgb-gauss-1", Variant::Series { order: 2, fit: Fit::RgbGaussians(1) }),
        ("poles:k=5", Variant::Poles { count: 5 }),
        ("windowed", Variant::Windowed { count: 6, groups: None }),
        ("cosines:m=2", Variant::Cosines { count: 6, order: 2 }),
        ("nodes:n=9", Variant::Nodes { count: 9 }),
        ("windowed:k=8,groups=3", Variant::Windowed { count: 8, groups: Some(3) }),
        ("series:m=4,fit=exact", Variant::Series { order: 4, fit: Fit::Exact }),
        ("baked:degree=5", Variant::Baked { degree: 5, denominator: 0 }),
        ("baked:degree=5,denominator=4", Variant::Baked { degree: 5, denominator: 4 }),
        ("table:16x256", Variant::Table { angles: 16, thicknesses: 256 }),
        ("fitted", Variant::Fitted { form: None, count: 6, rms_error: 6e-3 }),
        (
            "fitted:form=ks,k=3,rms=0.0015",
            Variant::Fitted { form: Some(FittedForm::Kernel), count: 3, rms_error: 1.5e-3 },
        ),
        (
            "fitted:form=three-orders",
            Variant::Fitted { form: Some(FittedForm::ThreeOrders), count: 4, rms_error: 6e-3 },
        ),
        ("series", Variant::Series { order: 3, fit: Fit::XyzGauss }),
        ("fresnel", Variant::Fresnel { form: FresnelForm::Exact }),
        ("fresnel:form=schlick", Variant::Fresnel { form: FresnelForm::Schlick }),
        ("spectral:n=16", Variant::Spectral { count: 16 }),
        ("spectral", Variant::Spectral { count: 81 }),
    ];
    for (text, expected) in cases {
        assert_eq!(text.parse(), Ok(expected), "{text}");
        assert_eq!(expected.to_string().parse(), Ok(expected), "{expected}");
    }
}

#[test]
fn what_is_no_variant_is_refused_with_help() {
    let cases = [
        ("", "unknown method ``", "series, poles"),
        ("sereis:m=3", "unknown method `sereis`", "series, poles"),
        ("series:m=0", "`m=0`", "from 1 to 32"),
        ("series:m=33", "`m=33`", "from 1 to 32"),
        ("series:m=-1", "`m=-1`", "from 1 to 32"),
        ("series:m", "`m` in the variant `series:m` has no value", "series takes m=3,fit=xyz-gauss"),
        ("series:k=3", "unknown option `k`", "series takes"),
        ("series:m=3,m=4", "`m` stands twice", "series takes"),
        ("series:fit=rgb", "unknown fit `rgb`", "xyz-gauss"),
        ("series:fit=rgb-gauss-6", "unknown fit `rgb-gauss-6`", "K from 1 to 5"),
        ("series:fit=rgb-gauss-", "unknown fit `rgb-gauss-`", "K from 1 to 5"),
        ("series:m=", "`m` in the variant `series:m=` has no value", "series takes m=3,fit=xyz-gauss"),
        ("windowed:k=6,groups=7", "`groups=7`", "at most k, here 6"),
        ("table:64", "`64` in the variant `table:64` is no size", "table:64x64"),
        ("table:1x8", "`1x8`", "table:64x64"),
        ("table:1024x1024", "`1024x1024`", "at most 4096 entries"),
        ("fresnel:form=cook", "unknown form `cook`", "exact and schlick"),
        ("fitted:form=kernels", "unknown form `kernels`", "angle-only, first-order"),
        ("fitted:rms=0", "`rms=0`", "a number above 0"),
        ("fitted:rms=nan", "`rms=nan`", "a number above 0"),
        ("fitted:k=13", "`k=13`", "from 1 to 12"),
        ("poles:k=2", "`k=2`", "from 3 to 8"),
        ("spectral:n=1", "`n=1`", "from 2 to 512"),
        ("spectral:n=99999999999999999999", "`n=99999999999999999999`", "from 2 to 512"),
    ];
    for (text, message, help) in cases {
        let error = text.parse::<Variant>().expect_err(text);
        assert!(error.to_string().contains(message), "{text}: {error}");
        assert!(error.help().contains(help), "{text}: {}", error.help());
    }
}

#[test]
fn candidates_are_all_readable() {
    for candidate in Variant::candidates() {
        assert_eq!(candidate.to_string().parse(), Ok(candidate));
    }
}
