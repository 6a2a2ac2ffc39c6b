// SPDX-License-Identifier: MIT
// Constants and tables of elementary.cpp, printed by tests/unit/elementary/tables.py.
// clang-format off
#pragma once

namespace phys::elementary {

inline constexpr double kStepsPerUnit = 0x1.71547652b82fep+5; ///< of exp: 32 / log 2
inline constexpr double kStepHigh = 0x1.62e42fefa0000p-6; ///< log(2) / 32, of 36 bits
inline constexpr double kStepLow = 0x1.cf79abc9e3b3ap-45; ///< and the rest
inline constexpr double kLog2High = 0x1.62e42fefa3800p-1; ///< of log: log 2, a multiple of 2^-42
inline constexpr double kLog2Low = 0x1.ef35793c76730p-45; ///< and the rest
inline constexpr double kQuartersPerRadian = 0x1.45f306dc9c883p-1; ///< of sin: 2 / pi
inline constexpr double kQuarter1 = 0x1.921fb54400000p+0; ///< part 1 of pi / 2, of 33 bits
inline constexpr double kQuarter2 = 0x1.0b4611a600000p-34; ///< part 2 of pi / 2, of 33 bits
inline constexpr double kQuarter3 = 0x1.3198a2e000000p-69; ///< part 3 of pi / 2, of 33 bits
inline constexpr double kQuarter4 = 0x1.b839a252049c1p-104; ///< part 4 of pi / 2, the rest
inline constexpr double kQuarterHigh = 0x1.921fb54442d18p+0; ///< of atan2: pi / 2
inline constexpr double kQuarterLow = 0x1.1a62633145c07p-54; ///< and the rest

/// 2^(i/32) and its rest.
inline constexpr double kPowers[][2] = {
    {0x1.0000000000000p+0, 0.0},
    {0x1.059b0d3158574p+0, 0x1.d73e2a475b465p-55},
    {0x1.0b5586cf9890fp+0, 0x1.8a62e4adc610bp-54},
    {0x1.11301d0125b51p+0, -0x1.6c51039449b3ap-54},
    {0x1.172b83c7d517bp+0, -0x1.19041b9d78a76p-55},
    {0x1.1d4873168b9aap+0, 0x1.e016e00a2643cp-54},
    {0x1.2387a6e756238p+0, 0x1.9b07eb6c70573p-54},
    {0x1.29e9df51fdee1p+0, 0x1.612e8afad1255p-55},
    {0x1.306fe0a31b715p+0, 0x1.6f46ad23182e4p-55},
    {0x1.371a7373aa9cbp+0, -0x1.63aeabf42eae2p-54},
    {0x1.3dea64c123422p+0, 0x1.ada0911f09ebcp-55},
    {0x1.44e086061892dp+0, 0x1.89b7a04ef80d0p-59},
    {0x1.4bfdad5362a27p+0, 0x1.d4397afec42e2p-56},
    {0x1.5342b569d4f82p+0, -0x1.07abe1db13cadp-55},
    {0x1.5ab07dd485429p+0, 0x1.6324c054647adp-54},
    {0x1.6247eb03a5585p+0, -0x1.383c17e40b497p-54},
    {0x1.6a09e667f3bcdp+0, -0x1.bdd3413b26456p-54},
    {0x1.71f75e8ec5f74p+0, -0x1.16e4786887a99p-55},
    {0x1.7a11473eb0187p+0, -0x1.41577ee04992fp-55},
    {0x1.82589994cce13p+0, -0x1.d4c1dd41532d8p-54},
    {0x1.8ace5422aa0dbp+0, 0x1.6e9f156864b27p-54},
    {0x1.93737b0cdc5e5p+0, -0x1.75fc781b57ebcp-57},
    {0x1.9c49182a3f090p+0, 0x1.c7c46b071f2bep-56},
    {0x1.a5503b23e255dp+0, -0x1.d2f6edb8d41e1p-54},
    {0x1.ae89f995ad3adp+0, 0x1.7a1cd345dcc81p-54},
    {0x1.b7f76f2fb5e47p+0, -0x1.5584f7e54ac3bp-56},
    {0x1.c199bdd85529cp+0, 0x1.11065895048ddp-55},
    {0x1.cb720dcef9069p+0, 0x1.503cbd1e949dbp-56},
    {0x1.d5818dcfba487p+0, 0x1.2ed02d75b3707p-55},
    {0x1.dfc97337b9b5fp+0, -0x1.1a5cd4f184b5cp-54},
    {0x1.ea4afa2a490dap+0, -0x1.e9c23179c2893p-54},
    {0x1.f50765b6e4540p+0, 0x1.9d3e12dd8a18bp-54},
};

/// From i = 45: 1/c with 17 bits for c near i/64; log c, a multiple of 2^-42; its rest.
inline constexpr double kLogarithms[][3] = {
    {0x1.6c17000000000p+0, -0x1.68ad33e9b8000p-2, 0x1.faf2781b82bc3p-44},
    {0x1.642d000000000p+0, -0x1.522c40734e000p-2, 0x1.09d506add0abfp-44},
    {0x1.5c99000000000p+0, -0x1.3c269772f1000p-2, 0x1.ed34e8e4edefbp-48},
    {0x1.5555000000000p+0, -0x1.269521132e000p-2, 0x1.1b77465e77b87p-44},
    {0x1.4e5e000000000p+0, -0x1.1178c8227e000p-2, 0x1.c210fb8fb4d72p-45},
    {0x1.47ae000000000p+0, -0x1.f99146cb38000p-3, 0x1.90d0a22d25d89p-44},
    {0x1.4141000000000p+0, -0x1.d101df262c000p-3, 0x1.6140dc85030edp-45},
    {0x1.3b14000000000p+0, -0x1.a940d3c86e000p-3, 0x1.86f98a62b76a5p-45},
    {0x1.3522000000000p+0, -0x1.823d565502000p-3, 0x1.87c35c41ba709p-44},
    {0x1.2f68000000000p+0, -0x1.5bf206b504000p-3, 0x1.2757941bdeda4p-46},
    {0x1.29e4000000000p+0, -0x1.365f4b0156000p-3, 0x1.fd3a6050efe70p-44},
    {0x1.2492000000000p+0, -0x1.1176e8223e000p-3, -0x1.1ecce23025d2ep-45},
    {0x1.1f70000000000p+0, -0x1.da6e7637c4000p-4, -0x1.a83eac951c1aap-46},
    {0x1.1a7c000000000p+0, -0x1.933be5d474000p-4, -0x1.31a5c3835489cp-45},
    {0x1.15b2000000000p+0, -0x1.4d3295d1f4000p-4, -0x1.eac6fa7cf6de1p-44},
    {0x1.1111000000000p+0, -0x1.08588b59dc000p-4, 0x1.7e5f2c55fe581p-46},
    {0x1.0c97000000000p+0, -0x1.89482149e0000p-5, -0x1.1a190213e2f76p-44},
    {0x1.0842000000000p+0, -0x1.0413d89e68000p-5, 0x1.dddcd49b75a6bp-44},
    {0x1.0410000000000p+0, -0x1.01f5658730000p-6, -0x1.6107d26f92eb5p-44},
    {0x1.0000000000000p+0, 0.0, 0.0},
    {0x1.f820000000000p-1, 0x1.fbea8b13c0000p-7, 0x1.ec927b17e4e13p-50},
    {0x1.f07c000000000p-1, 0x1.f82db0e7a0000p-6, 0x1.980312729348fp-45},
    {0x1.e914000000000p-1, 0x1.77368f66b0000p-5, 0x1.ceab23b20a79dp-45},
    {0x1.e1e2000000000p-1, 0x1.f0a10c0128000p-5, -0x1.d59a92de0b93cp-45},
    {0x1.dae6000000000p-1, 0x1.341db961bc000p-4, 0x1.9d092aed8cba6p-44},
    {0x1.d41e000000000p-1, 0x1.6f06a8afa8000p-4, 0x1.68bc6775aa563p-45},
    {0x1.cd86000000000p-1, 0x1.a92193a588000p-4, 0x1.d60614c9016aap-44},
    {0x1.c71c000000000p-1, 0x1.e27476e330000p-4, -0x1.a31817fc55578p-45},
    {0x1.c0e0000000000p-1, 0x1.0d79e7cd48000p-3, 0x1.cb422847849e4p-44},
    {0x1.bad0000000000p-1, 0x1.29532f8240000p-3, -0x1.5babd495c735ep-44},
    {0x1.b4e8000000000p-1, 0x1.44d336ccbc000p-3, -0x1.70cac0bdf22e7p-46},
    {0x1.af28000000000p-1, 0x1.5ff5070aba000p-3, -0x1.85719c2a69690p-44},
    {0x1.a98e000000000p-1, 0x1.7abd302264000p-3, -0x1.7752c72b84121p-46},
    {0x1.a41a000000000p-1, 0x1.9526e9cf5e000p-3, 0x1.ad27faf800790p-45},
    {0x1.9ec8000000000p-1, 0x1.af4114e950000p-3, -0x1.63cb9af155c90p-53},
    {0x1.999a000000000p-1, 0x1.c8fd7c79ea000p-3, -0x1.77bfa12ca2ef8p-45},
    {0x1.948c000000000p-1, 0x1.e26bb6e418000p-3, 0x1.6e7dcc9665548p-46},
    {0x1.8f9c000000000p-1, 0x1.fb9206d5e8000p-3, -0x1.d570000ec91dcp-47},
    {0x1.8acc000000000p-1, 0x1.0a312e2762000p-2, -0x1.c74682fbafbb5p-44},
    {0x1.8618000000000p-1, 0x1.1676cabada000p-2, 0x1.83963c8b4ab26p-44},
    {0x1.8182000000000p-1, 0x1.2292cfbd2f000p-2, -0x1.26c7ab52d1d54p-44},
    {0x1.7d06000000000p-1, 0x1.2e8e0bae12000p-2, 0x1.4c2700879c369p-44},
    {0x1.78a4000000000p-1, 0x1.3a66e55725000p-2, -0x1.0982fd174dd60p-45},
    {0x1.745e000000000p-1, 0x1.46163c228e000p-2, -0x1.42b847691edaap-46},
    {0x1.702e000000000p-1, 0x1.51aae872e0000p-2, -0x1.74bd8c5b5272cp-44},
    {0x1.6c16000000000p-1, 0x1.5d1dfbf611000p-2, 0x1.cd836429a6520p-46},
    {0x1.6816000000000p-1, 0x1.686df1e9f3000p-2, 0x1.abf06f6b4338dp-44},
};

/// atan(i/32) and its rest.
inline constexpr double kArcs[][2] = {
    {0.0, 0.0},
    {0x1.ffd55bba97625p-6, -0x1.5ec431444912cp-60},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.7ee182602f10fp-4, -0x1.cfb654c0c3d98p-58},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.3d6eee8c6626cp-3, 0x1.61a3b0ce9281bp-57},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.b90d7529260a2p-3, 0x1.17b10d2e0e5abp-61},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.18bf5a30bf178p-2, 0x1.30ca4748b1bf9p-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.530ad9951cd4ap-2, -0x1.2566480884082p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.8b24d394a1b25p-2, 0x1.b6d0ba3748fa8p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.c0db4c94ec9f0p-2, -0x1.cc1ce70934c34p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.f40dd0b541418p-2, -0x1.a3992dc382a23p-57},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1255d9bfbd2a9p-1, -0x1.2bdaee1c0ee35p-58},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.2958e59308e31p-1, -0x1.09e73b0c6c087p-56},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.3f13fb89e96f4p-1, 0x1.ecf8b492644f0p-56},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.538f57b89061fp-1, -0x1.1bb74abda520cp-55},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.66d663923e087p-1, -0x1.6ea6febe8bbbap-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.78f6bbd5d315ep-1, 0x1.406a089803740p-55},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.89ff5ff57f1f8p-1, -0x1.55b9a5e177a1bp-55},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

} // namespace phys::elementary
