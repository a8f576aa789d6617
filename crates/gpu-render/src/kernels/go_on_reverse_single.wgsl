// Compiled from reverse.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 15109e13297a9d56
// result: ab7c1ba9692b8daa

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) room_0 : u32,
    @align(4) depth_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(5) @group(0) var<storage, read> input_0 : array<u32>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

@binding(4) @group(0) var<storage, read> scene_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_0 : array<f32>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

struct Tuple_0
{
     value0_0 : f32,
};

fn s_apply_length_0( x_0 : vec3<f32>) -> Tuple_0
{
    var _S1 : Tuple_0 = Tuple_0( length(x_0) );
    return _S1;
}

struct s_bwdCallableCtx_length_0
{
     _S2 : vec3<f32>,
};

struct DiffPair_vectorx3Cfloatx2C3x3E_0
{
     primal_0 : vec3<f32>,
     differential_0 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_length_impl_0
{
     value0_1 : vec3<f32>,
};

struct s_bwdCallableCtx_length_impl_0
{
     value0_2 : s_paramCtx_s_bwdCallableCtx_length_impl_0,
};

struct s_bwdCallableCtx_sqrt_0
{
     _S3 : f32,
};

struct DiffPair_float_0
{
     primal_0 : f32,
     differential_0 : f32,
};

fn _d_sqrt_0( dpx_0 : ptr<function, DiffPair_float_0>,  dOut_0 : f32)
{
    var _S4 : f32 = 0.5f / sqrt(max(1.00000001168609742e-07f, (*dpx_0).primal_0)) * dOut_0;
    (*dpx_0).primal_0 = (*dpx_0).primal_0;
    (*dpx_0).differential_0 = _S4;
    return;
}

fn s_bwdProp_sqrt_0( ctx_0 : s_bwdCallableCtx_sqrt_0,  d_x_0 : ptr<function, f32>,  d_out_0 : f32)
{
    var _S5 : DiffPair_float_0;
    _S5.primal_0 = ctx_0._S3;
    _d_sqrt_0(&(_S5), d_out_0);
    (*d_x_0) = _S5.differential_0;
    return;
}

fn s_bwdProp_length_impl_0( _S6 : s_bwdCallableCtx_length_impl_0,  _S7 : ptr<function, vec3<f32>>,  _S8 : f32)
{
    var _S9 : f32 = _S6.value0_2.value0_1[i32(0)];
    var _S10 : f32 = _S6.value0_2.value0_1[i32(1)];
    var _S11 : f32 = _S6.value0_2.value0_1[i32(2)];
    var _S12 : s_bwdCallableCtx_sqrt_0;
    _S12._S3 = _S9 * _S9 + _S10 * _S10 + _S11 * _S11;
    var _S13 : f32 = 0.0f;
    s_bwdProp_sqrt_0(_S12, &(_S13), _S8);
    var _S14 : f32 = _S6.value0_2.value0_1[i32(2)] * _S13;
    var _S15 : f32 = _S14 + _S14;
    var _S16 : f32 = _S6.value0_2.value0_1[i32(1)] * _S13;
    var _S17 : f32 = _S16 + _S16;
    var _S18 : f32 = _S6.value0_2.value0_1[i32(0)] * _S13;
    var _S19 : f32 = _S18 + _S18;
    var _S20 : vec3<f32> = vec3<f32>(0.0f);
    _S20[i32(2)] = _S15;
    _S20[i32(1)] = _S17;
    _S20[i32(0)] = _S19;
    (*_S7) = _S20;
    return;
}

fn _S21( _S22 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S23 : f32)
{
    var _S24 : s_paramCtx_s_bwdCallableCtx_length_impl_0;
    _S24.value0_1 = (*_S22).primal_0;
    var _S25 : s_bwdCallableCtx_length_impl_0 = s_bwdCallableCtx_length_impl_0( _S24 );
    var _S26 : vec3<f32> = (*_S22).differential_0;
    s_bwdProp_length_impl_0(_S25, &(_S26), _S23);
    (*_S22).differential_0 = _S26;
    return;
}

fn s_bwdProp_length_0( ctx_1 : s_bwdCallableCtx_length_0,  d_x_1 : ptr<function, vec3<f32>>,  d_out_1 : f32)
{
    var _S27 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S27.primal_0 = ctx_1._S2;
    _S21(&(_S27), d_out_1);
    (*d_x_1) = _S27.differential_0;
    return;
}

struct Tuple_1
{
     value0_3 : vec2<f32>,
};

fn exponential_0( x_1 : f32) -> f32
{
    if(x_1 < -87.0f)
    {
        return 0.0f;
    }
    var power_0 : f32 = floor(x_1 * 1.4426950216293335f + 0.5f);
    var r_0 : f32 = x_1 - power_0 * 0.693359375f + power_0 * 0.00021219444170129f;
    return ((((((0.00019875691214111f * r_0 + 0.00139819993637502f) * r_0 + 0.00833345204591751f) * r_0 + 0.04166579619050026f) * r_0 + 0.1666666567325592f) * r_0 + 0.5f) * r_0 * r_0 + r_0 + 1.0f) * (bitcast<f32>(((u32(i32(power_0) + i32(127)) << (u32(23))))));
}

fn error_function_plus_one_0( x_2 : f32) -> vec2<f32>
{
    var _S28 : f32 = min(abs(x_2), 6.0f);
    var gaussian_0 : f32 = exponential_0(- _S28 * _S28);
    var place_0 : f32 = (_S28 - 2.0f) / (_S28 + 2.0f);
    var complement_0 : f32 = gaussian_0 * (((((((((-0.00042725281673484f * place_0 - 0.00127731403335929f) * place_0 + 0.00131371302995831f) * place_0 + 0.008666617795825f) * place_0 - 0.00805134233087301f) * place_0 - 0.05421232059597969f) * place_0 + 0.1640533059835434f) * place_0 - 0.16603080928325653f) * place_0 - 0.09276388585567474f) * place_0 + 1.27697837352752686f) / (1.0f + 2.0f * _S28);
    var _S29 : f32;
    if(x_2 < 0.0f)
    {
        _S29 = complement_0;
    }
    else
    {
        _S29 = 2.0f - complement_0;
    }
    return vec2<f32>(_S29, 1.128379225730896f * gaussian_0);
}

fn s_apply_error_function_plus_one_0( x_3 : f32) -> Tuple_1
{
    var _S30 : Tuple_1 = Tuple_1( error_function_plus_one_0(x_3) );
    return _S30;
}

struct s_bwdCallableCtx_error_function_plus_one_0
{
     _S31 : f32,
};

fn error_function_back_0( x_4 : ptr<function, DiffPair_float_0>,  weights_0 : vec2<f32>)
{
    var slope_0 : f32 = error_function_plus_one_0((*x_4).primal_0).y;
    var _S32 : f32 = dot(weights_0, vec2<f32>(slope_0, -2.0f * (*x_4).primal_0 * slope_0));
    (*x_4).primal_0 = (*x_4).primal_0;
    (*x_4).differential_0 = _S32;
    return;
}

fn s_bwdProp_error_function_plus_one_0( ctx_2 : s_bwdCallableCtx_error_function_plus_one_0,  d_x_2 : ptr<function, f32>,  d_out_2 : vec2<f32>)
{
    var _S33 : DiffPair_float_0;
    _S33.primal_0 = ctx_2._S31;
    error_function_back_0(&(_S33), d_out_2);
    (*d_x_2) = _S33.differential_0;
    return;
}

struct Tuple_2
{
     value0_4 : f32,
};

fn s_apply_dot_0( x_5 : vec2<f32>,  y_0 : vec2<f32>) -> Tuple_2
{
    var _S34 : Tuple_2 = Tuple_2( dot(x_5, y_0) );
    return _S34;
}

struct s_bwdCallableCtx_dot_0
{
     _S35 : vec2<f32>,
     _S36 : vec2<f32>,
};

struct DiffPair_vectorx3Cfloatx2C2x3E_0
{
     primal_0 : vec2<f32>,
     differential_0 : vec2<f32>,
};

fn _d_dot_0( dpx_1 : ptr<function, DiffPair_vectorx3Cfloatx2C2x3E_0>,  dpy_0 : ptr<function, DiffPair_vectorx3Cfloatx2C2x3E_0>,  dOut_1 : f32)
{
    var x_d_result_0 : vec2<f32>;
    x_d_result_0[i32(0)] = (*dpy_0).primal_0[i32(0)] * dOut_1;
    var y_d_result_0 : vec2<f32>;
    y_d_result_0[i32(0)] = (*dpx_1).primal_0[i32(0)] * dOut_1;
    x_d_result_0[i32(1)] = (*dpy_0).primal_0[i32(1)] * dOut_1;
    y_d_result_0[i32(1)] = (*dpx_1).primal_0[i32(1)] * dOut_1;
    (*dpx_1).primal_0 = (*dpx_1).primal_0;
    (*dpx_1).differential_0 = x_d_result_0;
    (*dpy_0).primal_0 = (*dpy_0).primal_0;
    (*dpy_0).differential_0 = y_d_result_0;
    return;
}

fn s_bwdProp_dot_0( ctx_3 : s_bwdCallableCtx_dot_0,  d_x_3 : ptr<function, vec2<f32>>,  d_y_0 : ptr<function, vec2<f32>>,  d_out_3 : f32)
{
    var _S37 : DiffPair_vectorx3Cfloatx2C2x3E_0;
    _S37.primal_0 = ctx_3._S35;
    var _S38 : DiffPair_vectorx3Cfloatx2C2x3E_0;
    _S38.primal_0 = ctx_3._S36;
    _d_dot_0(&(_S37), &(_S38), d_out_3);
    (*d_x_3) = _S37.differential_0;
    (*d_y_0) = _S38.differential_0;
    return;
}

struct Tuple_3
{
     value0_5 : f32,
};

fn s_apply_abs_0( x_6 : f32) -> Tuple_3
{
    var _S39 : Tuple_3 = Tuple_3( abs(x_6) );
    return _S39;
}

struct s_bwdCallableCtx_abs_0
{
     _S40 : f32,
};

fn _d_abs_0( dpx_2 : ptr<function, DiffPair_float_0>,  dOut_2 : f32)
{
    var _S41 : f32 = select(select(-1.0f, 0.0f, ((*dpx_2).primal_0) == 0.0f), 1.0f, ((*dpx_2).primal_0) > 0.0f) * dOut_2;
    (*dpx_2).primal_0 = (*dpx_2).primal_0;
    (*dpx_2).differential_0 = _S41;
    return;
}

fn s_bwdProp_abs_0( ctx_4 : s_bwdCallableCtx_abs_0,  d_x_4 : ptr<function, f32>,  d_out_4 : f32)
{
    var _S42 : DiffPair_float_0;
    _S42.primal_0 = ctx_4._S40;
    _d_abs_0(&(_S42), d_out_4);
    (*d_x_4) = _S42.differential_0;
    return;
}

struct Tuple_4
{
     value0_6 : f32,
};

fn s_apply_dot_1( x_7 : vec3<f32>,  y_1 : vec3<f32>) -> Tuple_4
{
    var _S43 : Tuple_4 = Tuple_4( dot(x_7, y_1) );
    return _S43;
}

struct s_bwdCallableCtx_dot_1
{
     _S44 : vec3<f32>,
     _S45 : vec3<f32>,
};

fn _d_dot_1( dpx_3 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dpy_1 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dOut_3 : f32)
{
    var x_d_result_1 : vec3<f32>;
    x_d_result_1[i32(0)] = (*dpy_1).primal_0[i32(0)] * dOut_3;
    var y_d_result_1 : vec3<f32>;
    y_d_result_1[i32(0)] = (*dpx_3).primal_0[i32(0)] * dOut_3;
    x_d_result_1[i32(1)] = (*dpy_1).primal_0[i32(1)] * dOut_3;
    y_d_result_1[i32(1)] = (*dpx_3).primal_0[i32(1)] * dOut_3;
    x_d_result_1[i32(2)] = (*dpy_1).primal_0[i32(2)] * dOut_3;
    y_d_result_1[i32(2)] = (*dpx_3).primal_0[i32(2)] * dOut_3;
    (*dpx_3).primal_0 = (*dpx_3).primal_0;
    (*dpx_3).differential_0 = x_d_result_1;
    (*dpy_1).primal_0 = (*dpy_1).primal_0;
    (*dpy_1).differential_0 = y_d_result_1;
    return;
}

fn s_bwdProp_dot_1( ctx_5 : s_bwdCallableCtx_dot_1,  d_x_5 : ptr<function, vec3<f32>>,  d_y_1 : ptr<function, vec3<f32>>,  d_out_5 : f32)
{
    var _S46 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S46.primal_0 = ctx_5._S44;
    var _S47 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S47.primal_0 = ctx_5._S45;
    _d_dot_1(&(_S46), &(_S47), d_out_5);
    (*d_x_5) = _S46.differential_0;
    (*d_y_1) = _S47.differential_0;
    return;
}

struct Tuple_5
{
     value0_7 : vec3<f32>,
};

fn s_apply_normalize_0( x_8 : vec3<f32>) -> Tuple_5
{
    var _S48 : Tuple_5 = Tuple_5( normalize(x_8) );
    return _S48;
}

struct s_bwdCallableCtx_normalize_0
{
     _S49 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_normalize_impl_0
{
     value0_8 : vec3<f32>,
};

struct s_bwdCallableCtx_normalize_impl_0
{
     value0_9 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0,
};

fn s_bwdProp_normalize_impl_0( _S50 : s_bwdCallableCtx_normalize_impl_0,  _S51 : ptr<function, vec3<f32>>,  _S52 : vec3<f32>)
{
    var _S53 : Tuple_0 = s_apply_length_0(_S50.value0_9.value0_8);
    var _S54 : s_bwdCallableCtx_length_0;
    _S54._S2 = _S50.value0_9.value0_8;
    var _S55 : vec3<f32> = _S50.value0_9.value0_8 * _S52;
    var _S56 : vec3<f32> = vec3<f32>((1.0f / _S53.value0_0)) * _S52;
    var _S57 : f32 = - ((_S55[i32(0)] + _S55[i32(1)] + _S55[i32(2)]) / (_S53.value0_0 * _S53.value0_0));
    var _S58 : vec3<f32> = vec3<f32>(0.0f);
    s_bwdProp_length_0(_S54, &(_S58), _S57);
    (*_S51) = _S56 + _S58;
    return;
}

fn _S59( _S60 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S61 : vec3<f32>)
{
    var _S62 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0;
    _S62.value0_8 = (*_S60).primal_0;
    var _S63 : s_bwdCallableCtx_normalize_impl_0 = s_bwdCallableCtx_normalize_impl_0( _S62 );
    var _S64 : vec3<f32> = (*_S60).differential_0;
    s_bwdProp_normalize_impl_0(_S63, &(_S64), _S61);
    (*_S60).differential_0 = _S64;
    return;
}

fn s_bwdProp_normalize_0( ctx_6 : s_bwdCallableCtx_normalize_0,  d_x_6 : ptr<function, vec3<f32>>,  d_out_6 : vec3<f32>)
{
    var _S65 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S65.primal_0 = ctx_6._S49;
    _S59(&(_S65), d_out_6);
    (*d_x_6) = _S65.differential_0;
    return;
}

struct Tuple_6
{
     value0_10 : vec2<f32>,
};

fn s_apply_max_0( x_9 : vec2<f32>,  y_2 : vec2<f32>) -> Tuple_6
{
    var _S66 : Tuple_6 = Tuple_6( max(x_9, y_2) );
    return _S66;
}

struct s_bwdCallableCtx_max_0
{
     _S67 : vec2<f32>,
     _S68 : vec2<f32>,
};

fn _d_max_0( dpx_4 : ptr<function, DiffPair_float_0>,  dpy_2 : ptr<function, DiffPair_float_0>,  dOut_4 : f32)
{
    var _S69 : DiffPair_float_0 = (*dpx_4);
    var _S70 : f32;
    if(((*dpx_4).primal_0) > ((*dpy_2).primal_0))
    {
        _S70 = dOut_4;
    }
    else
    {
        if(((*dpx_4).primal_0) < ((*dpy_2).primal_0))
        {
            _S70 = 0.0f;
        }
        else
        {
            _S70 = 0.5f * dOut_4;
        }
    }
    (*dpx_4).primal_0 = _S69.primal_0;
    (*dpx_4).differential_0 = _S70;
    var _S71 : DiffPair_float_0 = (*dpy_2);
    if(((*dpy_2).primal_0) > (_S69.primal_0))
    {
        _S70 = dOut_4;
    }
    else
    {
        if(((*dpy_2).primal_0) < ((*dpx_4).primal_0))
        {
            _S70 = 0.0f;
        }
        else
        {
            _S70 = 0.5f * dOut_4;
        }
    }
    (*dpy_2).primal_0 = _S71.primal_0;
    (*dpy_2).differential_0 = _S70;
    return;
}

fn _d_max_vector_0( dpx_5 : ptr<function, DiffPair_vectorx3Cfloatx2C2x3E_0>,  dpy_3 : ptr<function, DiffPair_vectorx3Cfloatx2C2x3E_0>,  dOut_5 : vec2<f32>)
{
    var left_dp_0 : DiffPair_float_0;
    left_dp_0.primal_0 = (*dpx_5).primal_0[i32(0)];
    left_dp_0.differential_0 = 0.0f;
    var right_dp_0 : DiffPair_float_0;
    right_dp_0.primal_0 = (*dpy_3).primal_0[i32(0)];
    right_dp_0.differential_0 = 0.0f;
    _d_max_0(&(left_dp_0), &(right_dp_0), dOut_5[i32(0)]);
    var left_d_result_0 : vec2<f32>;
    left_d_result_0[i32(0)] = left_dp_0.differential_0;
    var right_d_result_0 : vec2<f32>;
    right_d_result_0[i32(0)] = right_dp_0.differential_0;
    var left_dp_1 : DiffPair_float_0;
    left_dp_1.primal_0 = (*dpx_5).primal_0[i32(1)];
    left_dp_1.differential_0 = 0.0f;
    var right_dp_1 : DiffPair_float_0;
    right_dp_1.primal_0 = (*dpy_3).primal_0[i32(1)];
    right_dp_1.differential_0 = 0.0f;
    _d_max_0(&(left_dp_1), &(right_dp_1), dOut_5[i32(1)]);
    left_d_result_0[i32(1)] = left_dp_1.differential_0;
    right_d_result_0[i32(1)] = right_dp_1.differential_0;
    (*dpx_5).primal_0 = (*dpx_5).primal_0;
    (*dpx_5).differential_0 = left_d_result_0;
    (*dpy_3).primal_0 = (*dpy_3).primal_0;
    (*dpy_3).differential_0 = right_d_result_0;
    return;
}

fn s_bwdProp_max_0( ctx_7 : s_bwdCallableCtx_max_0,  d_x_7 : ptr<function, vec2<f32>>,  d_y_2 : ptr<function, vec2<f32>>,  d_out_7 : vec2<f32>)
{
    var _S72 : DiffPair_vectorx3Cfloatx2C2x3E_0;
    _S72.primal_0 = ctx_7._S67;
    var _S73 : DiffPair_vectorx3Cfloatx2C2x3E_0;
    _S73.primal_0 = ctx_7._S68;
    _d_max_vector_0(&(_S72), &(_S73), d_out_7);
    (*d_x_7) = _S72.differential_0;
    (*d_y_2) = _S73.differential_0;
    return;
}

struct Tuple_7
{
     value0_11 : f32,
};

fn s_apply_sqrt_0( x_10 : f32) -> Tuple_7
{
    var _S74 : Tuple_7 = Tuple_7( sqrt(x_10) );
    return _S74;
}

struct Numbers_0
{
     diffuse_reflectance_0 : vec3<f32>,
     specular_reflectance_0 : vec3<f32>,
     eta_0 : vec3<f32>,
     k_0 : vec3<f32>,
     alpha_0 : vec2<f32>,
};

struct Lobe_0
{
     record_0 : u32,
     kind_0 : u32,
     distribution_0 : u32,
     numbers_0 : Numbers_0,
};

struct DiffPair_Numbers_0
{
     primal_0 : Numbers_0,
     differential_0 : Numbers_0,
};

struct Scattering_Differential_0
{
     value_0 : vec3<f32>,
};

struct Scattering_0
{
     value_1 : vec3<f32>,
     pdf_0 : f32,
};

struct s_minCtx_s_bwdCallableCtx_transmittance_0
{
     value0_12 : f32,
     value1_0 : f32,
};

struct s_minCtx_s_bwdCallableCtx_base_0
{
     value0_13 : f32,
     value1_1 : u32,
};

struct s_minCtx_s_bwdCallableCtx_scattering_0
{
     value0_14 : f32,
     value1_2 : s_minCtx_s_bwdCallableCtx_transmittance_0,
     value2_0 : f32,
     value3_0 : s_minCtx_s_bwdCallableCtx_transmittance_0,
     value4_0 : vec3<f32>,
     value5_0 : s_minCtx_s_bwdCallableCtx_base_0,
};

struct Tuple_8
{
     value0_15 : Scattering_0,
     value1_3 : s_minCtx_s_bwdCallableCtx_scattering_0,
};

struct Mirrored_0
{
     cosine_0 : f32,
     pdf_1 : f32,
     scattered_0 : f32,
};

struct Tuple_9
{
     value0_16 : Mirrored_0,
};

fn s_apply_Mirrored_x24init_0( _S75 : f32,  _S76 : f32,  _S77 : f32) -> Tuple_9
{
    var _S78 : Tuple_9;
    _S78.value0_16.cosine_0 = _S75;
    _S78.value0_16.pdf_1 = _S76;
    _S78.value0_16.scattered_0 = _S77;
    return _S78;
}

fn is_rough_0( lobe_0 : Lobe_0) -> bool
{
    var _S79 : bool;
    if((lobe_0.kind_0) == u32(2))
    {
        _S79 = true;
    }
    else
    {
        _S79 = (lobe_0.kind_0) == u32(4);
    }
    return _S79;
}

struct Microfacets_0
{
     distribution_1 : u32,
     alpha_1 : vec2<f32>,
};

struct Tuple_10
{
     value0_17 : Microfacets_0,
};

fn s_apply_facets_of_0( lobe_1 : Lobe_0,  _S80 : Numbers_0) -> Tuple_10
{
    var _S81 : Tuple_6 = s_apply_max_0(_S80.alpha_0, vec2<f32>(0.00009999999747379f));
    var _S82 : Tuple_10;
    _S82.value0_17.distribution_1 = lobe_1.distribution_0;
    _S82.value0_17.alpha_1 = _S81.value0_10;
    return _S82;
}

struct Tuple_11
{
     value0_18 : Mirrored_0,
};

struct Tuple_12
{
     value0_19 : f32,
};

struct Tuple_13
{
     value0_20 : f32,
};

fn s_apply_exponential_0( _S83 : f32) -> Tuple_13
{
    var _S84 : f32;
    if(!(_S83 < -87.0f))
    {
        var power_1 : f32 = floor(_S83 * 1.4426950216293335f + 0.5f);
        var r_1 : f32 = _S83 - power_1 * 0.693359375f + power_1 * 0.00021219444170129f;
        _S84 = ((((((0.00019875691214111f * r_1 + 0.00139819993637502f) * r_1 + 0.00833345204591751f) * r_1 + 0.04166579619050026f) * r_1 + 0.1666666567325592f) * r_1 + 0.5f) * r_1 * r_1 + r_1 + 1.0f) * (bitcast<f32>(((u32(i32(power_1) + i32(127)) << (u32(23))))));
    }
    else
    {
        _S84 = 0.0f;
    }
    var _S85 : Tuple_13;
    _S85.value0_20 = _S84;
    return _S85;
}

fn s_apply_density_0( _S86 : Microfacets_0,  _S87 : vec3<f32>) -> Tuple_12
{
    var _S88 : f32 = _S87.z;
    var _S89 : bool = !(_S88 <= 0.0f);
    var _S90 : f32;
    if(_S89)
    {
        var scale_0 : f32 = 3.14159274101257324f * _S86.alpha_1.x * _S86.alpha_1.y;
        var slope_1 : vec2<f32> = _S87.xy / _S86.alpha_1;
        var _S91 : Tuple_2 = s_apply_dot_0(slope_1, slope_1);
        var cos2_0 : f32 = _S88 * _S88;
        var _runFlag_0 : bool;
        if((_S86.distribution_1) == u32(1))
        {
            var sum_0 : f32 = _S91.value0_4 + cos2_0;
            var _S92 : f32 = 1.0f / (scale_0 * sum_0 * sum_0);
            _runFlag_0 = false;
            _S90 = _S92;
        }
        else
        {
            _runFlag_0 = _S89;
            _S90 = 0.0f;
        }
        if(_runFlag_0)
        {
            var exponent_0 : f32 = _S91.value0_4 / cos2_0;
            if(exponent_0 > 80.0f)
            {
                _S90 = 0.0f;
            }
            else
            {
                _S90 = s_apply_exponential_0(- exponent_0).value0_20 / (scale_0 * cos2_0 * cos2_0);
            }
        }
    }
    else
    {
        _S90 = 0.0f;
    }
    var _S93 : Tuple_12;
    _S93.value0_19 = _S90;
    return _S93;
}

struct Tuple_14
{
     value0_21 : f32,
};

fn s_apply_visible_over_cos_0( _S94 : Microfacets_0,  _S95 : vec3<f32>) -> Tuple_14
{
    var stretched_0 : vec2<f32> = _S95.xy * _S94.alpha_1;
    var _S96 : Tuple_2 = s_apply_dot_0(stretched_0, stretched_0);
    var _S97 : f32 = _S95.z;
    var z2_0 : f32 = _S97 * _S97;
    var _S98 : bool = (_S94.distribution_1) == u32(1);
    var _S99 : f32;
    if(_S98)
    {
        _S99 = 2.0f / (_S97 + s_apply_sqrt_0(z2_0 + _S96.value0_4).value0_11);
    }
    var _S100 : bool = !_S98;
    if(_S100)
    {
        var _runFlag_1 : bool;
        if(z2_0 >= (36.0f * _S96.value0_4))
        {
            var _S101 : f32 = 1.0f / _S97;
            _runFlag_1 = false;
            _S99 = _S101;
        }
        else
        {
            _runFlag_1 = _S100;
        }
        if(_runFlag_1)
        {
            var _S102 : Tuple_7 = s_apply_sqrt_0(_S96.value0_4);
            var _S103 : Tuple_1 = s_apply_error_function_plus_one_0(_S97 / _S102.value0_11);
            _S99 = 2.0f / (_S97 * _S103.value0_3.x + 0.5f * _S102.value0_11 * _S103.value0_3.y);
        }
    }
    var _S104 : Tuple_14;
    _S104.value0_21 = _S99;
    return _S104;
}

fn s_apply_mirrored_0( _S105 : Microfacets_0,  _S106 : vec3<f32>,  _S107 : vec3<f32>) -> Tuple_11
{
    var _S108 : Tuple_5 = s_apply_normalize_0(_S106 + _S107);
    var _S109 : f32 = 0.25f * s_apply_density_0(_S105, _S108.value0_7).value0_19 * s_apply_visible_over_cos_0(_S105, _S106).value0_21;
    var _S110 : f32 = _S109 * s_apply_visible_over_cos_0(_S105, _S107).value0_21 * _S107.z;
    var _S111 : Tuple_11;
    _S111.value0_18.cosine_0 = s_apply_dot_1(_S106, _S108.value0_7).value0_6;
    _S111.value0_18.pdf_1 = _S109;
    _S111.value0_18.scattered_0 = _S110;
    return _S111;
}

struct Tuple_15
{
     value0_22 : vec3<f32>,
};

struct Tuple_16
{
     value0_23 : f32,
};

fn s_apply_fresnel_conductor_channel_0( _S112 : f32,  _S113 : f32,  _S114 : f32) -> Tuple_16
{
    var cos2_1 : f32 = _S112 * _S112;
    var sin2_0 : f32 = 1.0f - cos2_1;
    var real_0 : f32 = _S113 * _S113 - _S114 * _S114 - sin2_0;
    var product_0 : f32 = _S113 * _S114;
    var _S115 : Tuple_7 = s_apply_sqrt_0(real_0 * real_0 + 4.0f * (product_0 * product_0));
    var a_0 : f32;
    if(!((_S115.value0_11) == 0.0f))
    {
        var _S116 : Tuple_7 = s_apply_sqrt_0(0.5f * (_S115.value0_11 + s_apply_abs_0(real_0).value0_5));
        var smaller_0 : f32 = product_0 / _S116.value0_11;
        var _S117 : bool = real_0 < 0.0f;
        if(_S117)
        {
            a_0 = smaller_0;
        }
        else
        {
            a_0 = _S116.value0_11;
        }
        var b_0 : f32;
        if(_S117)
        {
            b_0 = _S116.value0_11;
        }
        else
        {
            b_0 = smaller_0;
        }
        var less_0 : f32 = a_0 - _S112;
        var more_0 : f32 = a_0 + _S112;
        var _S118 : f32 = b_0 * b_0;
        var p_sum_0 : f32 = _S115.value0_11 * cos2_1 + sin2_0 * sin2_0;
        a_0 = (less_0 * less_0 + _S118) / (more_0 * more_0 + _S118) * p_sum_0 / (p_sum_0 + 2.0f * a_0 * _S112 * sin2_0);
    }
    else
    {
        a_0 = 1.0f;
    }
    var _S119 : Tuple_16;
    _S119.value0_23 = a_0;
    return _S119;
}

fn s_apply_fresnel_conductor_0( _S120 : f32,  _S121 : vec3<f32>,  _S122 : vec3<f32>) -> Tuple_15
{
    var _S123 : Tuple_15;
    _S123.value0_22 = vec3<f32>(s_apply_fresnel_conductor_channel_0(_S120, _S121.x, _S122.x).value0_23, s_apply_fresnel_conductor_channel_0(_S120, _S121.y, _S122.y).value0_23, s_apply_fresnel_conductor_channel_0(_S120, _S121.z, _S122.z).value0_23);
    return _S123;
}

struct Tuple_17
{
     value0_24 : f32,
};

struct Tuple_18
{
     value0_25 : f32,
};

fn s_apply_luminance_0( _S124 : vec3<f32>) -> Tuple_18
{
    var _S125 : Tuple_18;
    _S125.value0_25 = s_apply_dot_1(_S124, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f)).value0_6;
    return _S125;
}

fn s_apply_coat_eta_0( _S126 : Numbers_0) -> Tuple_17
{
    var _S127 : Tuple_17;
    _S127.value0_24 = s_apply_luminance_0(_S126.eta_0).value0_25 / s_apply_luminance_0(_S126.k_0).value0_25;
    return _S127;
}

struct Tuple_19
{
     value0_26 : f32,
     value1_4 : s_minCtx_s_bwdCallableCtx_transmittance_0,
};

struct Tuple_20
{
     value0_27 : f32,
};

fn s_apply_fresnel_dielectric_0( _S128 : f32,  _S129 : f32) -> Tuple_20
{
    var eta2_0 : f32 = _S129 * _S129;
    var cos2_2 : f32 = _S128 * _S128;
    var denser_0 : f32 = (_S129 - 1.0f) * (_S129 + 1.0f);
    var squared_0 : f32 = denser_0 + cos2_2;
    var _S130 : f32;
    if(!(squared_0 <= 0.0f))
    {
        var _S131 : Tuple_7 = s_apply_sqrt_0(squared_0);
        var s_sum_0 : f32 = _S128 + _S131.value0_11;
        var p_sum_1 : f32 = eta2_0 * _S128 + _S131.value0_11;
        var senkrecht_0 : f32 = denser_0 / (s_sum_0 * s_sum_0);
        var parallel_0 : f32 = denser_0 * ((eta2_0 + 1.0f) * cos2_2 - 1.0f) / (p_sum_1 * p_sum_1);
        _S130 = 0.5f * (senkrecht_0 * senkrecht_0 + parallel_0 * parallel_0);
    }
    else
    {
        _S130 = 1.0f;
    }
    var _S132 : Tuple_20;
    _S132.value0_27 = _S130;
    return _S132;
}

fn word_0( at_0 : u32) -> u32
{
    return scene_0[at_0];
}

fn number_0( at_1 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_1])));
}

fn s_apply_transmittance_0( lobe_2 : Lobe_0,  _S133 : f32,  _S134 : f32) -> Tuple_19
{
    var _S135 : s_minCtx_s_bwdCallableCtx_transmittance_0;
    _S135.value0_12 = 0.0f;
    _S135.value1_0 = 0.0f;
    var _S136 : bool = (lobe_2.kind_0) == u32(3);
    var _S137 : f32;
    if(_S136)
    {
        _S137 = 1.0f - s_apply_fresnel_dielectric_0(_S134, _S133).value0_27;
    }
    var _S138 : bool = !_S136;
    if(_S138)
    {
        var place_1 : f32 = _S134 * 63.0f;
        var _S139 : u32 = min(u32(place_1), u32(62));
        var at_2 : u32 = word_0(lobe_2.record_0 + u32(3)) + _S139;
        var here_0 : f32 = number_0(at_2);
        _S135.value0_12 = here_0;
        var next_0 : f32 = number_0(at_2 + u32(1));
        _S135.value1_0 = next_0;
        _S137 = here_0 + (next_0 - here_0) * (place_1 - f32(_S139));
    }
    var _S140 : Tuple_19;
    _S140.value0_26 = _S137;
    _S140.value1_4 = _S135;
    return _S140;
}

struct Tuple_21
{
     value0_28 : vec3<f32>,
     value1_5 : s_minCtx_s_bwdCallableCtx_base_0,
};

struct Tuple_22
{
     value0_29 : f32,
};

fn s_apply_fresnel_diffuse_0( _S141 : f32) -> Tuple_22
{
    var inverse_0 : f32 = 1.0f / _S141;
    var _S142 : bool = _S141 < 1.0f;
    var _S143 : f32;
    if(_S142)
    {
        _S143 = (-1.43990004062652588f * _S141 + 0.70990002155303955f) * _S141 + 0.66809999942779541f + 0.06360000371932983f * inverse_0;
    }
    var _S144 : bool = !_S142;
    if(_S144)
    {
        _S143 = ((((-1.36881005764007568f * inverse_0 + 4.98553991317749023f) * inverse_0 - 7.80988979339599609f) * inverse_0 + 6.75334978103637695f) * inverse_0 - 3.47930002212524414f) * inverse_0 + 0.91931700706481934f;
    }
    var _S145 : Tuple_22;
    _S145.value0_29 = _S143;
    return _S145;
}

fn s_apply_base_0( lobe_3 : Lobe_0,  _S146 : f32,  _S147 : vec3<f32>) -> Tuple_21
{
    var _S148 : s_minCtx_s_bwdCallableCtx_base_0;
    _S148.value0_13 = 0.0f;
    _S148.value1_1 = u32(0);
    var internal_reflectance_0 : f32;
    if((lobe_3.kind_0) == u32(3))
    {
        internal_reflectance_0 = s_apply_fresnel_diffuse_0(1.0f / _S146).value0_29;
    }
    else
    {
        var _S149 : f32 = number_0(word_0(lobe_3.record_0 + u32(3)) + u32(64));
        _S148.value0_13 = _S149;
        internal_reflectance_0 = _S149;
    }
    var _S150 : u32 = word_0(lobe_3.record_0 + u32(2));
    _S148.value1_1 = _S150;
    var _S151 : bool = _S150 == u32(0);
    var _S152 : vec3<f32>;
    if(_S151)
    {
        _S152 = _S147 * vec3<f32>((1.0f / (1.0f - internal_reflectance_0)));
    }
    var _S153 : bool = !_S151;
    if(_S153)
    {
        _S152 = _S147 / (vec3<f32>(1.0f) - _S147 * vec3<f32>(internal_reflectance_0));
    }
    var _S154 : Tuple_21;
    _S154.value0_28 = _S152;
    _S154.value1_5 = _S148;
    return _S154;
}

fn choice_weight_0( colour_0 : vec3<f32>) -> f32
{
    return max((colour_0.x + colour_0.y + colour_0.z) / 3.0f, 0.05000000074505806f);
}

fn base_probability_0( numbers_1 : Numbers_0,  enters_0 : f32) -> f32
{
    var of_base_0 : f32 = enters_0 * choice_weight_0(numbers_1.diffuse_reflectance_0);
    return of_base_0 / (of_base_0 + (1.0f - enters_0) * choice_weight_0(numbers_1.specular_reflectance_0));
}

fn s_apply_scattering_0( lobe_4 : Lobe_0,  _S155 : Numbers_0,  _S156 : vec3<f32>,  _S157 : vec3<f32>) -> Tuple_8
{
    var _S158 : s_minCtx_s_bwdCallableCtx_transmittance_0 = s_minCtx_s_bwdCallableCtx_transmittance_0( 0.0f, 0.0f );
    var _S159 : vec3<f32> = vec3<f32>(0.0f);
    var _S160 : s_minCtx_s_bwdCallableCtx_base_0 = s_minCtx_s_bwdCallableCtx_base_0( 0.0f, u32(0) );
    var _S161 : s_minCtx_s_bwdCallableCtx_scattering_0;
    _S161.value0_14 = 0.0f;
    _S161.value1_2 = _S158;
    _S161.value2_0 = 0.0f;
    _S161.value3_0 = _S158;
    _S161.value4_0 = _S159;
    _S161.value5_0 = _S160;
    var _S162 : f32 = _S157.z;
    var by_cosine_0 : f32 = _S162 * 0.31830987334251404f;
    var _S163 : bool = (lobe_4.kind_0) == u32(0);
    var scattering_0 : Scattering_0;
    if(_S163)
    {
        scattering_0.value_1 = _S155.diffuse_reflectance_0 * vec3<f32>(by_cosine_0);
        scattering_0.pdf_0 = by_cosine_0;
    }
    var _S164 : bool = !_S163;
    if(_S164)
    {
        var _S165 : Tuple_9 = s_apply_Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
        var by_facets_0 : Mirrored_0;
        if(is_rough_0(lobe_4))
        {
            by_facets_0 = s_apply_mirrored_0(s_apply_facets_of_0(lobe_4, _S155).value0_17, _S156, _S157).value0_18;
        }
        else
        {
            by_facets_0 = _S165.value0_16;
        }
        var _runFlag_2 : bool;
        if((lobe_4.kind_0) == u32(2))
        {
            var _S166 : vec3<f32> = _S155.specular_reflectance_0 * (s_apply_fresnel_conductor_0(by_facets_0.cosine_0, _S155.eta_0, _S155.k_0).value0_22 * vec3<f32>(by_facets_0.scattered_0));
            _runFlag_2 = false;
            scattering_0.value_1 = _S166;
            scattering_0.pdf_0 = by_facets_0.pdf_1;
        }
        else
        {
            _runFlag_2 = _S164;
        }
        if(_runFlag_2)
        {
            var _S167 : Tuple_17 = s_apply_coat_eta_0(_S155);
            var _S168 : Tuple_19 = s_apply_transmittance_0(lobe_4, _S167.value0_24, _S156.z);
            _S161.value0_14 = _S168.value0_26;
            _S161.value1_2 = _S168.value1_4;
            var _S169 : Tuple_19 = s_apply_transmittance_0(lobe_4, _S167.value0_24, _S162);
            _S161.value2_0 = _S169.value0_26;
            _S161.value3_0 = _S169.value1_4;
            var _S170 : Tuple_21 = s_apply_base_0(lobe_4, _S167.value0_24, _S155.diffuse_reflectance_0);
            _S161.value4_0 = _S170.value0_28;
            _S161.value5_0 = _S170.value1_5;
            var _S171 : vec3<f32> = _S170.value0_28 * vec3<f32>((_S168.value0_26 * _S169.value0_26 * by_cosine_0 / (_S167.value0_24 * _S167.value0_24)));
            var probability_0 : f32 = base_probability_0(_S155, _S168.value0_26);
            var _S172 : f32 = probability_0 * by_cosine_0;
            if((lobe_4.kind_0) == u32(4))
            {
                var _S173 : f32 = _S172 + (1.0f - probability_0) * by_facets_0.pdf_1;
                scattering_0.value_1 = _S171 + _S155.specular_reflectance_0 * vec3<f32>((s_apply_fresnel_dielectric_0(by_facets_0.cosine_0, _S167.value0_24).value0_27 * by_facets_0.scattered_0));
                scattering_0.pdf_0 = _S173;
            }
            else
            {
                scattering_0.value_1 = _S171;
                scattering_0.pdf_0 = _S172;
            }
        }
    }
    var _S174 : Tuple_8;
    _S174.value0_15 = scattering_0;
    _S174.value1_3 = _S161;
    return _S174;
}

struct s_paramCtx_s_bwdCallableCtx_scattering_0
{
     value0_30 : Lobe_0,
     value1_6 : Numbers_0,
     value2_1 : vec3<f32>,
     value3_1 : vec3<f32>,
};

struct s_bwdCallableCtx_scattering_0
{
     value0_31 : s_paramCtx_s_bwdCallableCtx_scattering_0,
     value1_7 : s_minCtx_s_bwdCallableCtx_scattering_0,
};

struct s_paramCtx_s_bwdCallableCtx_facets_of_0
{
     value0_32 : Numbers_0,
};

struct s_paramCtx_s_bwdCallableCtx_mirrored_0
{
     value0_33 : Microfacets_0,
     value1_8 : vec3<f32>,
     value2_2 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0
{
     value0_34 : f32,
     value1_9 : vec3<f32>,
     value2_3 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_coat_eta_0
{
     value0_35 : Numbers_0,
};

struct s_paramCtx_s_bwdCallableCtx_transmittance_0
{
     value0_36 : Lobe_0,
     value1_10 : f32,
     value2_4 : f32,
};

struct s_paramCtx_s_bwdCallableCtx_base_0
{
     value0_37 : Lobe_0,
     value1_11 : f32,
     value2_5 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0
{
     value0_38 : f32,
     value1_12 : f32,
};

struct s_bwdCallableCtx_mirrored_0
{
     value0_39 : s_paramCtx_s_bwdCallableCtx_mirrored_0,
};

struct s_bwdCallableCtx_facets_of_0
{
     value0_40 : s_paramCtx_s_bwdCallableCtx_facets_of_0,
};

struct s_bwdCallableCtx_fresnel_conductor_0
{
     value0_41 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0,
};

struct s_bwdCallableCtx_fresnel_dielectric_0
{
     value0_42 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0,
};

struct s_bwdCallableCtx_base_0
{
     value0_43 : s_paramCtx_s_bwdCallableCtx_base_0,
     value1_13 : s_minCtx_s_bwdCallableCtx_base_0,
};

struct s_bwdCallableCtx_transmittance_0
{
     value0_44 : s_paramCtx_s_bwdCallableCtx_transmittance_0,
     value1_14 : s_minCtx_s_bwdCallableCtx_transmittance_0,
};

struct s_bwdCallableCtx_coat_eta_0
{
     value0_45 : s_paramCtx_s_bwdCallableCtx_coat_eta_0,
};

fn Numbers_x24_syn_dzero_0() -> Numbers_0
{
    var result_0 : Numbers_0;
    var _S175 : vec3<f32> = vec3<f32>(0.0f);
    result_0.diffuse_reflectance_0 = _S175;
    result_0.specular_reflectance_0 = _S175;
    result_0.eta_0 = _S175;
    result_0.k_0 = _S175;
    result_0.alpha_0 = vec2<f32>(0.0f);
    return result_0;
}

fn Mirrored_x24_syn_dzero_0() -> Mirrored_0
{
    var result_1 : Mirrored_0;
    result_1.cosine_0 = 0.0f;
    result_1.pdf_1 = 0.0f;
    result_1.scattered_0 = 0.0f;
    return result_1;
}

fn Scattering_x24_syn_dzero_0() -> Scattering_Differential_0
{
    var result_2 : Scattering_Differential_0;
    result_2.value_0 = vec3<f32>(0.0f);
    return result_2;
}

fn Scattering_x24_syn_dadd_0( SLANG_anonymous_0_0 : Scattering_Differential_0,  SLANG_anonymous_1_0 : Scattering_Differential_0) -> Scattering_Differential_0
{
    var result_3 : Scattering_Differential_0;
    result_3.value_0 = SLANG_anonymous_0_0.value_0 + SLANG_anonymous_1_0.value_0;
    return result_3;
}

fn s_bwdProp_fresnel_dielectric_0( _S176 : s_bwdCallableCtx_fresnel_dielectric_0,  _S177 : ptr<function, f32>,  _S178 : ptr<function, f32>,  _S179 : f32)
{
    var _S180 : f32 = _S176.value0_42.value1_12;
    var eta2_1 : f32 = _S180 * _S180;
    var _S181 : f32 = _S176.value0_42.value0_38;
    var cos2_3 : f32 = _S181 * _S181;
    var _S182 : f32 = _S176.value0_42.value1_12 - 1.0f;
    var _S183 : f32 = _S176.value0_42.value1_12 + 1.0f;
    var denser_1 : f32 = _S182 * _S183;
    var squared_1 : f32 = denser_1 + cos2_3;
    var _S184 : bool = !(squared_1 <= 0.0f);
    var _S185 : f32;
    var _S186 : f32;
    var _S187 : f32;
    var _S188 : f32;
    var _S189 : f32;
    var _S190 : f32;
    var _S191 : f32;
    var _S192 : f32;
    var _S193 : f32;
    var _S194 : f32;
    var _S195 : f32;
    var _S196 : s_bwdCallableCtx_sqrt_0;
    if(_S184)
    {
        var _S197 : Tuple_7 = s_apply_sqrt_0(squared_1);
        var _S198 : s_bwdCallableCtx_sqrt_0;
        _S198._S3 = squared_1;
        var s_sum_1 : f32 = _S176.value0_42.value0_38 + _S197.value0_11;
        var p_sum_2 : f32 = eta2_1 * _S176.value0_42.value0_38 + _S197.value0_11;
        var _S199 : f32 = s_sum_1 * s_sum_1;
        var senkrecht_1 : f32 = denser_1 / _S199;
        var _S200 : f32 = _S199 * _S199;
        var _S201 : f32 = eta2_1 + 1.0f;
        var _S202 : f32 = _S201 * cos2_3 - 1.0f;
        var _S203 : f32 = denser_1 * _S202;
        var _S204 : f32 = p_sum_2 * p_sum_2;
        var _S205 : f32 = _S204 * _S204;
        _S185 = _S203 / _S204;
        _S186 = senkrecht_1;
        _S187 = _S205;
        _S188 = _S203;
        _S189 = _S204;
        _S190 = p_sum_2;
        _S191 = _S202;
        _S192 = _S201;
        _S193 = _S200;
        _S194 = _S199;
        _S195 = s_sum_1;
        _S196 = _S198;
    }
    else
    {
        _S185 = 0.0f;
        _S186 = 0.0f;
        _S187 = 0.0f;
        _S188 = 0.0f;
        _S189 = 0.0f;
        _S190 = 0.0f;
        _S191 = 0.0f;
        _S192 = 0.0f;
        _S193 = 0.0f;
        _S194 = 0.0f;
        _S195 = 0.0f;
        _S196._S3 = 0.0f;
    }
    if(_S184)
    {
        var _S206 : f32 = 0.5f * _S179;
        var _S207 : f32 = _S185 * _S206;
        var _S208 : f32 = _S186 * _S206;
        var _S209 : f32 = (_S207 + _S207) / _S187;
        var _S210 : f32 = _S189 * _S209;
        var _S211 : f32 = _S190 * (_S188 * - _S209);
        var _S212 : f32 = denser_1 * _S210;
        var _S213 : f32 = _S191 * _S210;
        var _S214 : f32 = _S192 * _S212;
        var _S215 : f32 = cos2_3 * _S212;
        var _S216 : f32 = (_S208 + _S208) / _S193;
        var _S217 : f32 = _S194 * _S216;
        var _S218 : f32 = _S195 * (denser_1 * - _S216);
        var _S219 : f32 = _S211 + _S211;
        var _S220 : f32 = eta2_1 * _S219;
        var _S221 : f32 = _S176.value0_42.value0_38 * _S219;
        var _S222 : f32 = _S218 + _S218;
        var _S223 : f32 = _S219 + _S222;
        var _S224 : f32 = 0.0f;
        s_bwdProp_sqrt_0(_S196, &(_S224), _S223);
        var _S225 : f32 = _S215 + _S221;
        var _S226 : f32 = _S220 + _S222;
        var _S227 : f32 = _S213 + _S217;
        _S185 = _S224;
        _S186 = _S227;
        _S187 = _S214;
        _S188 = _S225;
        _S189 = _S226;
    }
    else
    {
        _S185 = 0.0f;
        _S186 = 0.0f;
        _S187 = 0.0f;
        _S188 = 0.0f;
        _S189 = 0.0f;
    }
    var _S228 : f32 = _S185 + _S186;
    var _S229 : f32 = _S176.value0_42.value0_38 * (_S185 + _S187);
    var _S230 : f32 = _S176.value0_42.value1_12 * _S188;
    var _S231 : f32 = _S182 * _S228 + _S183 * _S228 + _S230 + _S230;
    (*_S177) = _S229 + _S229 + _S189;
    (*_S178) = _S231;
    return;
}

fn Mirrored_x24_syn_dadd_0( SLANG_anonymous_0_1 : Mirrored_0,  SLANG_anonymous_1_1 : Mirrored_0) -> Mirrored_0
{
    var result_4 : Mirrored_0;
    result_4.cosine_0 = SLANG_anonymous_0_1.cosine_0 + SLANG_anonymous_1_1.cosine_0;
    result_4.pdf_1 = SLANG_anonymous_0_1.pdf_1 + SLANG_anonymous_1_1.pdf_1;
    result_4.scattered_0 = SLANG_anonymous_0_1.scattered_0 + SLANG_anonymous_1_1.scattered_0;
    return result_4;
}

fn Numbers_x24_syn_dadd_0( SLANG_anonymous_0_2 : Numbers_0,  SLANG_anonymous_1_2 : Numbers_0) -> Numbers_0
{
    var result_5 : Numbers_0;
    result_5.diffuse_reflectance_0 = SLANG_anonymous_0_2.diffuse_reflectance_0 + SLANG_anonymous_1_2.diffuse_reflectance_0;
    result_5.specular_reflectance_0 = SLANG_anonymous_0_2.specular_reflectance_0 + SLANG_anonymous_1_2.specular_reflectance_0;
    result_5.eta_0 = SLANG_anonymous_0_2.eta_0 + SLANG_anonymous_1_2.eta_0;
    result_5.k_0 = SLANG_anonymous_0_2.k_0 + SLANG_anonymous_1_2.k_0;
    result_5.alpha_0 = SLANG_anonymous_0_2.alpha_0 + SLANG_anonymous_1_2.alpha_0;
    return result_5;
}

struct s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0
{
     value0_46 : f32,
};

struct s_bwdCallableCtx_fresnel_diffuse_0
{
     value0_47 : s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0,
};

fn s_bwdProp_fresnel_diffuse_0( _S232 : s_bwdCallableCtx_fresnel_diffuse_0,  _S233 : ptr<function, f32>,  _S234 : f32)
{
    var inverse_1 : f32 = 1.0f / _S232.value0_47.value0_46;
    var _S235 : f32 = _S232.value0_47.value0_46 * _S232.value0_47.value0_46;
    var _S236 : bool = (_S232.value0_47.value0_46) < 1.0f;
    var _S237 : f32;
    if(_S236)
    {
        _S237 = -1.43990004062652588f * _S232.value0_47.value0_46 + 0.70990002155303955f;
    }
    else
    {
        _S237 = 0.0f;
    }
    var _S238 : bool = !_S236;
    var _S239 : f32;
    var _S240 : f32;
    var _S241 : f32;
    var _S242 : f32;
    if(_S238)
    {
        var _S243 : f32 = -1.36881005764007568f * inverse_1 + 4.98553991317749023f;
        var _S244 : f32 = _S243 * inverse_1 - 7.80988979339599609f;
        var sum_1 : f32 = _S244 * inverse_1 + 6.75334978103637695f;
        _S239 = sum_1 * inverse_1 - 3.47930002212524414f;
        _S240 = sum_1;
        _S241 = _S244;
        _S242 = _S243;
    }
    else
    {
        _S239 = 0.0f;
        _S240 = 0.0f;
        _S241 = 0.0f;
        _S242 = 0.0f;
    }
    if(_S238)
    {
        var _S245 : f32 = inverse_1 * _S234;
        var s_diff_sum_T_0 : f32 = inverse_1 * _S245;
        var _S246 : f32 = inverse_1 * s_diff_sum_T_0;
        var _S247 : f32 = _S239 * _S234 + _S240 * _S245 + _S241 * s_diff_sum_T_0 + _S242 * _S246 + -1.36881005764007568f * (inverse_1 * _S246);
        _S239 = 0.0f;
        _S240 = _S247;
    }
    else
    {
        _S239 = _S234;
        _S240 = 0.0f;
    }
    if(_S236)
    {
        var _S248 : f32 = _S237 * _S239 + -1.43990004062652588f * (_S232.value0_47.value0_46 * _S239);
        _S237 = 0.06360000371932983f * _S239 + _S240;
        _S239 = _S248;
    }
    else
    {
        _S237 = _S240;
        _S239 = 0.0f;
    }
    (*_S233) = - (_S237 / _S235) + _S239;
    return;
}

fn s_bwdProp_base_0( _S249 : s_bwdCallableCtx_base_0,  _S250 : ptr<function, f32>,  _S251 : ptr<function, vec3<f32>>,  _S252 : vec3<f32>)
{
    var _S253 : s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0 = s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0( 0.0f );
    var _S254 : vec3<f32> = vec3<f32>(0.0f);
    var _S255 : bool = (_S249.value0_43.value0_37.kind_0) == u32(3);
    var internal_reflectance_1 : f32;
    var _S256 : f32;
    var _S257 : s_bwdCallableCtx_fresnel_diffuse_0;
    if(_S255)
    {
        var _S258 : f32 = 1.0f / _S249.value0_43.value1_11;
        var _S259 : f32 = _S249.value0_43.value1_11 * _S249.value0_43.value1_11;
        var _S260 : Tuple_22 = s_apply_fresnel_diffuse_0(_S258);
        var _S261 : s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0;
        _S261.value0_46 = _S258;
        internal_reflectance_1 = _S260.value0_29;
        _S257.value0_47 = _S261;
        _S256 = _S259;
    }
    else
    {
        internal_reflectance_1 = _S249.value1_13.value0_13;
        _S257.value0_47 = _S253;
        _S256 = 0.0f;
    }
    var _S262 : vec3<f32> = vec3<f32>(internal_reflectance_1);
    var _S263 : bool = (_S249.value1_13.value1_1) == u32(0);
    var _S264 : f32;
    var _S265 : vec3<f32>;
    if(_S263)
    {
        var _S266 : f32 = 1.0f - internal_reflectance_1;
        var _S267 : f32 = _S266 * _S266;
        _S265 = vec3<f32>((1.0f / _S266));
        _S264 = _S267;
    }
    else
    {
        _S265 = _S254;
        _S264 = 0.0f;
    }
    var _S268 : bool = !_S263;
    var _S269 : vec3<f32>;
    var _S270 : vec3<f32>;
    if(_S268)
    {
        var _S271 : vec3<f32> = vec3<f32>(1.0f) - _S249.value0_43.value2_5 * vec3<f32>(internal_reflectance_1);
        _S269 = _S271 * _S271;
        _S270 = _S271;
    }
    else
    {
        _S269 = _S254;
        _S270 = _S254;
    }
    var _S272 : vec3<f32>;
    if(_S268)
    {
        var _S273 : vec3<f32> = _S252 / _S269;
        var _S274 : vec3<f32> = (vec3<f32>(0) - _S249.value0_43.value2_5 * (vec3<f32>(0) - _S273));
        var _S275 : vec3<f32> = _S249.value0_43.value2_5 * _S274;
        var _S276 : vec3<f32> = _S270 * _S273 + _S262 * _S274;
        _S269 = _S254;
        _S270 = _S276;
        _S272 = _S275;
    }
    else
    {
        _S269 = _S252;
        _S270 = _S254;
        _S272 = _S254;
    }
    if(_S263)
    {
        var _S277 : vec3<f32> = _S249.value0_43.value2_5 * _S269;
        var _S278 : vec3<f32> = _S265 * _S269 + _S270;
        internal_reflectance_1 = - - ((_S277[i32(0)] + _S277[i32(1)] + _S277[i32(2)]) / _S264);
        _S265 = _S278;
    }
    else
    {
        internal_reflectance_1 = 0.0f;
        _S265 = _S270;
    }
    var _S279 : f32 = _S272[i32(0)] + _S272[i32(1)] + _S272[i32(2)] + internal_reflectance_1;
    if(_S255)
    {
        var _S280 : f32 = 0.0f;
        s_bwdProp_fresnel_diffuse_0(_S257, &(_S280), _S279);
        internal_reflectance_1 = - (_S280 / _S256);
    }
    else
    {
        internal_reflectance_1 = 0.0f;
    }
    (*_S250) = internal_reflectance_1;
    (*_S251) = _S265;
    return;
}

fn s_bwdProp_transmittance_0( _S281 : s_bwdCallableCtx_transmittance_0,  _S282 : ptr<function, f32>,  _S283 : ptr<function, f32>,  _S284 : f32)
{
    var _S285 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0 = s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0( 0.0f, 0.0f );
    var _S286 : bool = (_S281.value0_44.value0_36.kind_0) == u32(3);
    var _S287 : s_bwdCallableCtx_fresnel_dielectric_0;
    if(_S286)
    {
        var _S288 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0;
        _S288.value0_38 = _S281.value0_44.value2_4;
        _S288.value1_12 = _S281.value0_44.value1_10;
        _S287.value0_42 = _S288;
    }
    else
    {
        _S287.value0_42 = _S285;
    }
    var _S289 : bool = !_S286;
    var _S290 : f32;
    if(_S289)
    {
        _S290 = _S281.value1_14.value1_0 - _S281.value1_14.value0_12;
    }
    else
    {
        _S290 = 0.0f;
    }
    var _S291 : f32;
    if(_S289)
    {
        var _S292 : f32 = 63.0f * (_S290 * _S284);
        _S290 = 0.0f;
        _S291 = _S292;
    }
    else
    {
        _S290 = _S284;
        _S291 = 0.0f;
    }
    if(_S286)
    {
        var _S293 : f32 = - _S290;
        var _S294 : f32 = 0.0f;
        var _S295 : f32 = 0.0f;
        s_bwdProp_fresnel_dielectric_0(_S287, &(_S294), &(_S295), _S293);
        var _S296 : f32 = _S294 + _S291;
        _S290 = _S295;
        _S291 = _S296;
    }
    else
    {
        _S290 = 0.0f;
    }
    (*_S282) = _S290;
    (*_S283) = _S291;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_luminance_0
{
     value0_48 : vec3<f32>,
};

struct s_bwdCallableCtx_luminance_0
{
     value0_49 : s_paramCtx_s_bwdCallableCtx_luminance_0,
};

fn s_bwdProp_luminance_0( _S297 : s_bwdCallableCtx_luminance_0,  _S298 : ptr<function, vec3<f32>>,  _S299 : f32)
{
    var _S300 : s_bwdCallableCtx_dot_1;
    _S300._S44 = _S297.value0_49.value0_48;
    _S300._S45 = vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f);
    var _S301 : vec3<f32> = vec3<f32>(0.0f);
    var _S302 : vec3<f32> = _S301;
    var _S303 : vec3<f32> = _S301;
    s_bwdProp_dot_1(_S300, &(_S302), &(_S303), _S299);
    (*_S298) = _S302;
    return;
}

fn s_bwdProp_coat_eta_0( _S304 : s_bwdCallableCtx_coat_eta_0,  _S305 : ptr<function, Numbers_0>,  _S306 : f32)
{
    var _S307 : Tuple_18 = s_apply_luminance_0(_S304.value0_45.value0_35.eta_0);
    var _S308 : s_paramCtx_s_bwdCallableCtx_luminance_0;
    _S308.value0_48 = _S304.value0_45.value0_35.eta_0;
    var _S309 : s_bwdCallableCtx_luminance_0 = s_bwdCallableCtx_luminance_0( _S308 );
    var _S310 : Tuple_18 = s_apply_luminance_0(_S304.value0_45.value0_35.k_0);
    var _S311 : s_paramCtx_s_bwdCallableCtx_luminance_0;
    _S311.value0_48 = _S304.value0_45.value0_35.k_0;
    var _S312 : s_bwdCallableCtx_luminance_0 = s_bwdCallableCtx_luminance_0( _S311 );
    var _S313 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S314 : f32 = _S306 / (_S310.value0_25 * _S310.value0_25);
    var _S315 : f32 = _S307.value0_25 * - _S314;
    var _S316 : f32 = _S310.value0_25 * _S314;
    var _S317 : vec3<f32> = vec3<f32>(0.0f);
    var _S318 : vec3<f32> = _S317;
    s_bwdProp_luminance_0(_S312, &(_S318), _S315);
    var _S319 : vec3<f32> = _S317;
    s_bwdProp_luminance_0(_S309, &(_S319), _S316);
    var _S320 : Numbers_0 = _S313;
    _S320.k_0 = _S318;
    _S320.eta_0 = _S319;
    (*_S305) = Numbers_x24_syn_dadd_0(_S313, _S320);
    return;
}

struct s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0
{
     value0_50 : f32,
     value1_15 : f32,
     value2_6 : f32,
};

struct s_bwdCallableCtx_fresnel_conductor_channel_0
{
     value0_51 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0,
};

fn s_bwdProp_fresnel_conductor_channel_0( _S321 : s_bwdCallableCtx_fresnel_conductor_channel_0,  _S322 : ptr<function, f32>,  _S323 : ptr<function, f32>,  _S324 : ptr<function, f32>,  _S325 : f32)
{
    var _S326 : f32 = _S321.value0_51.value0_50;
    var cos2_4 : f32 = _S326 * _S326;
    var sin2_1 : f32 = 1.0f - cos2_4;
    var _S327 : f32 = _S321.value0_51.value1_15;
    var _S328 : f32 = _S321.value0_51.value2_6;
    var real_1 : f32 = _S327 * _S327 - _S328 * _S328 - sin2_1;
    var product_1 : f32 = _S321.value0_51.value1_15 * _S321.value0_51.value2_6;
    var _S329 : f32 = real_1 * real_1 + 4.0f * (product_1 * product_1);
    var _S330 : Tuple_7 = s_apply_sqrt_0(_S329);
    var _S331 : s_bwdCallableCtx_sqrt_0;
    _S331._S3 = _S329;
    var _S332 : s_bwdCallableCtx_sqrt_0 = _S331;
    var _S333 : bool = !((_S330.value0_11) == 0.0f);
    var a_1 : f32;
    var b_1 : f32;
    var _S334 : f32;
    var _S335 : f32;
    var _S336 : f32;
    var _S337 : f32;
    var _S338 : f32;
    var _S339 : f32;
    var _S340 : f32;
    var _S341 : f32;
    var _S342 : f32;
    var _S343 : f32;
    var _S344 : f32;
    var _S345 : f32;
    var _S346 : f32;
    var _S347 : bool;
    var _S348 : s_bwdCallableCtx_sqrt_0;
    var _S349 : s_bwdCallableCtx_abs_0;
    if(_S333)
    {
        var _S350 : Tuple_3 = s_apply_abs_0(real_1);
        var _S351 : s_bwdCallableCtx_abs_0;
        _S351._S40 = real_1;
        var _S352 : s_bwdCallableCtx_abs_0 = _S351;
        var _S353 : f32 = 0.5f * (_S330.value0_11 + _S350.value0_5);
        var _S354 : Tuple_7 = s_apply_sqrt_0(_S353);
        var _S355 : s_bwdCallableCtx_sqrt_0;
        _S355._S3 = _S353;
        var _S356 : s_bwdCallableCtx_sqrt_0 = _S355;
        var smaller_1 : f32 = product_1 / _S354.value0_11;
        var _S357 : f32 = _S354.value0_11 * _S354.value0_11;
        var _S358 : bool = real_1 < 0.0f;
        if(_S358)
        {
            a_1 = smaller_1;
        }
        else
        {
            a_1 = _S354.value0_11;
        }
        if(_S358)
        {
            b_1 = _S354.value0_11;
        }
        else
        {
            b_1 = smaller_1;
        }
        var less_1 : f32 = a_1 - _S321.value0_51.value0_50;
        var more_1 : f32 = a_1 + _S321.value0_51.value0_50;
        var _S359 : f32 = b_1 * b_1;
        var _S360 : f32 = less_1 * less_1 + _S359;
        var _S361 : f32 = more_1 * more_1 + _S359;
        var senkrecht_2 : f32 = _S360 / _S361;
        var _S362 : f32 = _S361 * _S361;
        var p_sum_3 : f32 = _S330.value0_11 * cos2_4 + sin2_1 * sin2_1;
        var _S363 : f32 = senkrecht_2 * p_sum_3;
        var _S364 : f32 = 2.0f * a_1;
        var _S365 : f32 = _S364 * _S321.value0_51.value0_50;
        var _S366 : f32 = p_sum_3 + _S365 * sin2_1;
        var _S367 : f32 = b_1;
        a_1 = _S366 * _S366;
        b_1 = _S363;
        _S334 = _S366;
        _S335 = _S365;
        _S336 = _S364;
        _S337 = senkrecht_2;
        _S338 = p_sum_3;
        _S339 = _S362;
        _S340 = _S360;
        _S341 = _S361;
        _S342 = more_1;
        _S343 = _S367;
        _S344 = less_1;
        _S347 = _S358;
        _S345 = _S357;
        _S346 = _S354.value0_11;
        _S348 = _S356;
        _S349 = _S352;
    }
    else
    {
        a_1 = 0.0f;
        b_1 = 0.0f;
        _S334 = 0.0f;
        _S335 = 0.0f;
        _S336 = 0.0f;
        _S337 = 0.0f;
        _S338 = 0.0f;
        _S339 = 0.0f;
        _S340 = 0.0f;
        _S341 = 0.0f;
        _S342 = 0.0f;
        _S343 = 0.0f;
        _S344 = 0.0f;
        _S347 = false;
        _S345 = 0.0f;
        _S346 = 0.0f;
        _S348._S3 = 0.0f;
        _S349._S40 = 0.0f;
    }
    if(_S333)
    {
        var _S368 : f32 = _S325 / a_1;
        var _S369 : f32 = b_1 * - _S368;
        var _S370 : f32 = _S334 * _S368;
        var _S371 : f32 = sin2_1 * _S369;
        var _S372 : f32 = _S369 + _S337 * _S370;
        var _S373 : f32 = sin2_1 * _S372;
        var _S374 : f32 = _S330.value0_11 * _S372;
        var _S375 : f32 = cos2_4 * _S372;
        var _S376 : f32 = _S338 * _S370 / _S339;
        var _S377 : f32 = _S340 * - _S376;
        var _S378 : f32 = _S341 * _S376;
        var _S379 : f32 = _S342 * _S377;
        var _S380 : f32 = _S343 * (_S377 + _S378);
        var _S381 : f32 = _S344 * _S378;
        var _S382 : f32 = _S379 + _S379;
        var _S383 : f32 = _S381 + _S381;
        var _S384 : f32 = _S380 + _S380;
        var _S385 : f32 = 2.0f * (_S321.value0_51.value0_50 * _S371) + _S382 + _S383;
        var _S386 : f32 = _S335 * _S369 + _S373 + _S373;
        var _S387 : f32 = _S336 * _S371 + _S382 + - _S383;
        if(_S347)
        {
            a_1 = 0.0f;
            b_1 = _S384;
        }
        else
        {
            a_1 = _S384;
            b_1 = 0.0f;
        }
        if(_S347)
        {
            a_1 = _S385 + a_1;
        }
        else
        {
            b_1 = _S385 + b_1;
        }
        var _S388 : f32 = a_1 / _S345;
        var _S389 : f32 = _S346 * _S388;
        var _S390 : f32 = product_1 * - _S388 + b_1;
        var _S391 : f32 = 0.0f;
        s_bwdProp_sqrt_0(_S348, &(_S391), _S390);
        var _S392 : f32 = 0.5f * _S391;
        var _S393 : f32 = 0.0f;
        s_bwdProp_abs_0(_S349, &(_S393), _S392);
        a_1 = _S392 + _S375;
        b_1 = _S389;
        _S334 = _S393;
        _S335 = _S386;
        _S336 = _S374;
        _S337 = _S387;
    }
    else
    {
        a_1 = 0.0f;
        b_1 = 0.0f;
        _S334 = 0.0f;
        _S335 = 0.0f;
        _S336 = 0.0f;
        _S337 = 0.0f;
    }
    var _S394 : f32 = 0.0f;
    s_bwdProp_sqrt_0(_S332, &(_S394), a_1);
    var _S395 : f32 = product_1 * (4.0f * _S394);
    var _S396 : f32 = real_1 * _S394;
    var _S397 : f32 = _S395 + _S395 + b_1;
    var _S398 : f32 = _S396 + _S396 + _S334;
    var _S399 : f32 = - _S398;
    var _S400 : f32 = _S321.value0_51.value2_6 * _S399;
    var _S401 : f32 = _S321.value0_51.value1_15 * _S398;
    var _S402 : f32 = _S321.value0_51.value0_50 * (- (_S399 + _S335) + _S336);
    var _S403 : f32 = _S321.value0_51.value2_6 * _S397 + _S401 + _S401;
    var _S404 : f32 = _S321.value0_51.value1_15 * _S397 + _S400 + _S400;
    (*_S322) = _S402 + _S402 + _S337;
    (*_S323) = _S403;
    (*_S324) = _S404;
    return;
}

fn s_bwdProp_fresnel_conductor_0( _S405 : s_bwdCallableCtx_fresnel_conductor_0,  _S406 : ptr<function, f32>,  _S407 : ptr<function, vec3<f32>>,  _S408 : ptr<function, vec3<f32>>,  _S409 : vec3<f32>)
{
    var _S410 : f32 = _S405.value0_41.value1_9.x;
    var _S411 : f32 = _S405.value0_41.value2_3.x;
    var _S412 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0;
    _S412.value0_50 = _S405.value0_41.value0_34;
    _S412.value1_15 = _S410;
    _S412.value2_6 = _S411;
    var _S413 : s_bwdCallableCtx_fresnel_conductor_channel_0 = s_bwdCallableCtx_fresnel_conductor_channel_0( _S412 );
    var _S414 : f32 = _S405.value0_41.value1_9.y;
    var _S415 : f32 = _S405.value0_41.value2_3.y;
    var _S416 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0;
    _S416.value0_50 = _S405.value0_41.value0_34;
    _S416.value1_15 = _S414;
    _S416.value2_6 = _S415;
    var _S417 : s_bwdCallableCtx_fresnel_conductor_channel_0 = s_bwdCallableCtx_fresnel_conductor_channel_0( _S416 );
    var _S418 : f32 = _S405.value0_41.value1_9.z;
    var _S419 : f32 = _S405.value0_41.value2_3.z;
    var _S420 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0;
    _S420.value0_50 = _S405.value0_41.value0_34;
    _S420.value1_15 = _S418;
    _S420.value2_6 = _S419;
    var _S421 : s_bwdCallableCtx_fresnel_conductor_channel_0 = s_bwdCallableCtx_fresnel_conductor_channel_0( _S420 );
    var _S422 : f32 = 0.0f;
    var _S423 : f32 = 0.0f;
    var _S424 : f32 = 0.0f;
    s_bwdProp_fresnel_conductor_channel_0(_S421, &(_S422), &(_S423), &(_S424), _S409[i32(2)]);
    var _S425 : f32 = 0.0f;
    var _S426 : f32 = 0.0f;
    var _S427 : f32 = 0.0f;
    s_bwdProp_fresnel_conductor_channel_0(_S417, &(_S425), &(_S426), &(_S427), _S409[i32(1)]);
    var _S428 : f32 = 0.0f;
    var _S429 : f32 = 0.0f;
    var _S430 : f32 = 0.0f;
    s_bwdProp_fresnel_conductor_channel_0(_S413, &(_S428), &(_S429), &(_S430), _S409[i32(0)]);
    var _S431 : vec3<f32> = vec3<f32>(_S430, _S427, _S424);
    var _S432 : vec3<f32> = vec3<f32>(_S429, _S426, _S423);
    (*_S406) = _S422 + _S425 + _S428;
    (*_S407) = _S432;
    (*_S408) = _S431;
    return;
}

struct Microfacets_Differential_0
{
     alpha_2 : vec2<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_density_0
{
     value0_52 : Microfacets_0,
     value1_16 : vec3<f32>,
};

struct s_bwdCallableCtx_density_0
{
     value0_53 : s_paramCtx_s_bwdCallableCtx_density_0,
};

struct s_paramCtx_s_bwdCallableCtx_visible_over_cos_0
{
     value0_54 : Microfacets_0,
     value1_17 : vec3<f32>,
};

struct s_bwdCallableCtx_visible_over_cos_0
{
     value0_55 : s_paramCtx_s_bwdCallableCtx_visible_over_cos_0,
};

fn Microfacets_x24_syn_dzero_0() -> Microfacets_Differential_0
{
    var result_6 : Microfacets_Differential_0;
    result_6.alpha_2 = vec2<f32>(0.0f);
    return result_6;
}

fn Microfacets_x24_syn_dadd_0( SLANG_anonymous_0_3 : Microfacets_Differential_0,  SLANG_anonymous_1_3 : Microfacets_Differential_0) -> Microfacets_Differential_0
{
    var result_7 : Microfacets_Differential_0;
    result_7.alpha_2 = SLANG_anonymous_0_3.alpha_2 + SLANG_anonymous_1_3.alpha_2;
    return result_7;
}

fn s_bwdProp_visible_over_cos_0( _S433 : s_bwdCallableCtx_visible_over_cos_0,  _S434 : ptr<function, Microfacets_Differential_0>,  _S435 : ptr<function, vec3<f32>>,  _S436 : f32)
{
    var _S437 : vec2<f32> = _S433.value0_55.value1_17.xy;
    var stretched_1 : vec2<f32> = _S437 * _S433.value0_55.value0_54.alpha_1;
    var _S438 : Tuple_2 = s_apply_dot_0(stretched_1, stretched_1);
    var _S439 : s_bwdCallableCtx_dot_0;
    _S439._S35 = stretched_1;
    _S439._S36 = stretched_1;
    var _S440 : s_bwdCallableCtx_dot_0 = _S439;
    var _S441 : f32 = _S433.value0_55.value1_17.z;
    var z2_1 : f32 = _S441 * _S441;
    var _S442 : bool = (_S433.value0_55.value0_54.distribution_1) == u32(1);
    var _S443 : f32;
    var _S444 : s_bwdCallableCtx_sqrt_0;
    if(_S442)
    {
        var _S445 : f32 = z2_1 + _S438.value0_4;
        var _S446 : Tuple_7 = s_apply_sqrt_0(_S445);
        var _S447 : s_bwdCallableCtx_sqrt_0;
        _S447._S3 = _S445;
        var _S448 : f32 = _S441 + _S446.value0_11;
        _S443 = _S448 * _S448;
        _S444 = _S447;
    }
    else
    {
        _S443 = 0.0f;
        _S444._S3 = 0.0f;
    }
    var _S449 : bool = !_S442;
    var _S450 : f32;
    var _S451 : f32;
    var _S452 : f32;
    var _S453 : f32;
    var _S454 : f32;
    var _S455 : f32;
    var _S456 : f32;
    var _S457 : s_bwdCallableCtx_sqrt_0;
    var _runFlag_3 : bool;
    var _S458 : bool;
    var _S459 : s_bwdCallableCtx_error_function_plus_one_0;
    if(_S449)
    {
        var _S460 : bool = z2_1 >= (36.0f * _S438.value0_4);
        if(_S460)
        {
            _runFlag_3 = false;
            _S450 = z2_1;
        }
        else
        {
            _runFlag_3 = _S449;
            _S450 = 0.0f;
        }
        if(_runFlag_3)
        {
            var _S461 : Tuple_7 = s_apply_sqrt_0(_S438.value0_4);
            var _S462 : s_bwdCallableCtx_sqrt_0;
            _S462._S3 = _S438.value0_4;
            var _S463 : f32 = _S441 / _S461.value0_11;
            var _S464 : f32 = _S461.value0_11 * _S461.value0_11;
            var _S465 : Tuple_1 = s_apply_error_function_plus_one_0(_S463);
            var _S466 : s_bwdCallableCtx_error_function_plus_one_0;
            _S466._S31 = _S463;
            var _S467 : f32 = _S465.value0_3.x;
            var _S468 : f32 = 0.5f * _S461.value0_11;
            var _S469 : f32 = _S465.value0_3.y;
            var _S470 : f32 = _S441 * _S467 + _S468 * _S469;
            _S451 = _S470 * _S470;
            _S452 = _S468;
            _S453 = _S469;
            _S454 = _S467;
            _S459 = _S466;
            _S455 = _S464;
            _S456 = _S461.value0_11;
            _S457 = _S462;
        }
        else
        {
            _S451 = 0.0f;
            _S452 = 0.0f;
            _S453 = 0.0f;
            _S454 = 0.0f;
            _S459._S31 = 0.0f;
            _S455 = 0.0f;
            _S456 = 0.0f;
            _S457._S3 = 0.0f;
        }
        var _S471 : f32 = _S450;
        _S450 = _S451;
        _S451 = _S452;
        _S452 = _S453;
        _S453 = _S454;
        _S454 = _S455;
        _S455 = _S456;
        _S458 = _S460;
        _S456 = _S471;
    }
    else
    {
        _runFlag_3 = false;
        _S450 = 0.0f;
        _S451 = 0.0f;
        _S452 = 0.0f;
        _S453 = 0.0f;
        _S459._S31 = 0.0f;
        _S454 = 0.0f;
        _S455 = 0.0f;
        _S457._S3 = 0.0f;
        _S458 = false;
        _S456 = 0.0f;
    }
    var _S472 : Microfacets_Differential_0 = Microfacets_x24_syn_dzero_0();
    if(_S449)
    {
        if(_runFlag_3)
        {
            var _S473 : f32 = 2.0f * - (_S436 / _S450);
            var _S474 : f32 = 0.5f * (_S452 * _S473);
            var _S475 : f32 = _S453 * _S473;
            var _S476 : vec2<f32> = vec2<f32>(_S441 * _S473, _S451 * _S473);
            var _S477 : f32 = 0.0f;
            s_bwdProp_error_function_plus_one_0(_S459, &(_S477), _S476);
            var _S478 : f32 = _S477 / _S454;
            var _S479 : f32 = _S455 * _S478;
            var _S480 : f32 = _S474 + _S441 * - _S478;
            var _S481 : f32 = 0.0f;
            s_bwdProp_sqrt_0(_S457, &(_S481), _S480);
            var _S482 : f32 = _S475 + _S479;
            _S450 = 0.0f;
            _S451 = _S482;
            _S452 = _S481;
        }
        else
        {
            _S450 = _S436;
            _S451 = 0.0f;
            _S452 = 0.0f;
        }
        if(_S458)
        {
            var _S483 : f32 = - (_S450 / _S456) + _S451;
            _S450 = 0.0f;
            _S451 = _S483;
        }
    }
    else
    {
        _S450 = _S436;
        _S451 = 0.0f;
        _S452 = 0.0f;
    }
    if(_S442)
    {
        var _S484 : f32 = 2.0f * - (_S450 / _S443);
        var _S485 : f32 = 0.0f;
        s_bwdProp_sqrt_0(_S444, &(_S485), _S484);
        var _S486 : f32 = _S484 + _S451;
        var _S487 : f32 = _S485 + _S452;
        _S443 = _S485;
        _S450 = _S486;
        _S451 = _S487;
    }
    else
    {
        _S443 = 0.0f;
        _S450 = _S451;
        _S451 = _S452;
    }
    var _S488 : f32 = _S441 * _S443;
    var _S489 : f32 = _S488 + _S488 + _S450;
    var _S490 : vec2<f32> = vec2<f32>(0.0f);
    var _S491 : vec2<f32> = _S490;
    var _S492 : vec2<f32> = _S490;
    s_bwdProp_dot_0(_S440, &(_S491), &(_S492), _S451);
    var _S493 : vec2<f32> = _S491 + _S492;
    var _S494 : vec2<f32> = _S437 * _S493;
    var _S495 : vec2<f32> = _S433.value0_55.value0_54.alpha_1 * _S493;
    var _S496 : vec3<f32> = vec3<f32>(_S495[i32(0)], _S495[i32(1)], _S489);
    var _S497 : Microfacets_Differential_0 = _S472;
    _S497.alpha_2 = _S494;
    (*_S434) = Microfacets_x24_syn_dadd_0(_S472, _S497);
    (*_S435) = _S496;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_exponential_0
{
     value0_56 : f32,
};

struct s_bwdCallableCtx_exponential_0
{
     value0_57 : s_paramCtx_s_bwdCallableCtx_exponential_0,
};

fn s_bwdProp_exponential_0( _S498 : s_bwdCallableCtx_exponential_0,  _S499 : ptr<function, f32>,  _S500 : f32)
{
    var _S501 : bool = !((_S498.value0_57.value0_56) < -87.0f);
    var _S502 : f32;
    var _S503 : f32;
    var _S504 : f32;
    var _S505 : f32;
    var _S506 : f32;
    var _S507 : f32;
    var _S508 : f32;
    var _S509 : f32;
    if(_S501)
    {
        var power_2 : f32 = floor(_S498.value0_57.value0_56 * 1.4426950216293335f + 0.5f);
        var r_2 : f32 = _S498.value0_57.value0_56 - power_2 * 0.693359375f + power_2 * 0.00021219444170129f;
        var _S510 : f32 = 0.00019875691214111f * r_2 + 0.00139819993637502f;
        var _S511 : f32 = _S510 * r_2 + 0.00833345204591751f;
        var tail_0 : f32 = _S511 * r_2 + 0.04166579619050026f;
        var _S512 : f32 = tail_0 * r_2 + 0.1666666567325592f;
        var tail_1 : f32 = _S512 * r_2 + 0.5f;
        var _S513 : f32 = tail_1 * r_2;
        _S502 = (bitcast<f32>(((u32(i32(power_2) + i32(127)) << (u32(23))))));
        _S503 = _S513;
        _S504 = r_2;
        _S505 = tail_1;
        _S506 = _S512;
        _S507 = tail_0;
        _S508 = _S511;
        _S509 = _S510;
    }
    else
    {
        _S502 = 0.0f;
        _S503 = 0.0f;
        _S504 = 0.0f;
        _S505 = 0.0f;
        _S506 = 0.0f;
        _S507 = 0.0f;
        _S508 = 0.0f;
        _S509 = 0.0f;
    }
    if(_S501)
    {
        var _S514 : f32 = _S502 * _S500;
        var _S515 : f32 = _S504 * _S514;
        var s_diff_tail_T_0 : f32 = _S504 * _S515;
        var _S516 : f32 = _S504 * s_diff_tail_T_0;
        var s_diff_tail_T_1 : f32 = _S504 * _S516;
        var _S517 : f32 = _S504 * s_diff_tail_T_1;
        _S502 = _S514 + _S503 * _S514 + _S505 * _S515 + _S506 * s_diff_tail_T_0 + _S507 * _S516 + _S508 * s_diff_tail_T_1 + _S509 * _S517 + 0.00019875691214111f * (_S504 * _S517);
    }
    else
    {
        _S502 = 0.0f;
    }
    (*_S499) = _S502;
    return;
}

fn s_bwdProp_density_0( _S518 : s_bwdCallableCtx_density_0,  _S519 : ptr<function, Microfacets_Differential_0>,  _S520 : ptr<function, vec3<f32>>,  _S521 : f32)
{
    var _S522 : vec2<f32> = vec2<f32>(0.0f);
    var _S523 : s_paramCtx_s_bwdCallableCtx_exponential_0 = s_paramCtx_s_bwdCallableCtx_exponential_0( 0.0f );
    var _S524 : f32 = _S518.value0_53.value1_16.z;
    var _S525 : bool = !(_S524 <= 0.0f);
    var _runFlag_4 : bool;
    var _S526 : bool;
    var _S527 : bool;
    var _S528 : f32;
    var _S529 : f32;
    var _S530 : f32;
    var _S531 : f32;
    var _S532 : f32;
    var _S533 : f32;
    var _S534 : f32;
    var _S535 : f32;
    var _S536 : f32;
    var _S537 : f32;
    var _S538 : f32;
    var _S539 : f32;
    var _S540 : f32;
    var _S541 : s_bwdCallableCtx_exponential_0;
    var _S542 : s_bwdCallableCtx_dot_0;
    var _S543 : vec2<f32>;
    var _S544 : vec2<f32>;
    var _S545 : vec2<f32>;
    if(_S525)
    {
        var _S546 : f32 = 3.14159274101257324f * _S518.value0_53.value0_52.alpha_1.x;
        var _S547 : f32 = _S518.value0_53.value0_52.alpha_1.y;
        var scale_1 : f32 = _S546 * _S547;
        var _S548 : vec2<f32> = _S518.value0_53.value1_16.xy;
        var slope_2 : vec2<f32> = _S548 / _S518.value0_53.value0_52.alpha_1;
        var _S549 : vec2<f32> = _S518.value0_53.value0_52.alpha_1 * _S518.value0_53.value0_52.alpha_1;
        var _S550 : Tuple_2 = s_apply_dot_0(slope_2, slope_2);
        var _S551 : s_bwdCallableCtx_dot_0;
        _S551._S35 = slope_2;
        _S551._S36 = slope_2;
        var _S552 : s_bwdCallableCtx_dot_0 = _S551;
        var cos2_5 : f32 = _S524 * _S524;
        var _S553 : bool = (_S518.value0_53.value0_52.distribution_1) == u32(1);
        if(_S553)
        {
            var sum_2 : f32 = _S550.value0_4 + cos2_5;
            var _S554 : f32 = scale_1 * sum_2;
            var _S555 : f32 = _S554 * sum_2;
            var _S556 : f32 = _S555 * _S555;
            _runFlag_4 = false;
            _S528 = _S556;
            _S529 = _S554;
            _S530 = sum_2;
        }
        else
        {
            _runFlag_4 = _S525;
            _S528 = 0.0f;
            _S529 = 0.0f;
            _S530 = 0.0f;
        }
        if(_runFlag_4)
        {
            var exponent_1 : f32 = _S550.value0_4 / cos2_5;
            var _S557 : f32 = cos2_5 * cos2_5;
            var _S558 : bool = exponent_1 > 80.0f;
            if(_S558)
            {
                _S531 = 0.0f;
                _S532 = 0.0f;
                _S533 = 0.0f;
                _S534 = 0.0f;
                _S541.value0_57 = _S523;
            }
            else
            {
                var _S559 : f32 = - exponent_1;
                var _S560 : Tuple_13 = s_apply_exponential_0(_S559);
                var _S561 : s_paramCtx_s_bwdCallableCtx_exponential_0;
                _S561.value0_56 = _S559;
                var _S562 : f32 = scale_1 * cos2_5;
                var _S563 : f32 = _S562 * cos2_5;
                _S531 = _S563 * _S563;
                _S532 = _S560.value0_20;
                _S533 = _S563;
                _S534 = _S562;
                _S541.value0_57 = _S561;
            }
            _S526 = _S558;
            _S535 = _S557;
        }
        else
        {
            _S526 = false;
            _S531 = 0.0f;
            _S532 = 0.0f;
            _S533 = 0.0f;
            _S534 = 0.0f;
            _S541.value0_57 = _S523;
            _S535 = 0.0f;
        }
        var _S564 : f32 = _S528;
        var _S565 : f32 = _S529;
        var _S566 : f32 = _S530;
        _S528 = _S531;
        _S529 = _S532;
        _S530 = _S533;
        _S531 = _S534;
        _S532 = cos2_5;
        _S533 = scale_1;
        _S534 = _S535;
        _S535 = _S550.value0_4;
        _S527 = _S553;
        _S536 = _S564;
        _S537 = _S565;
        _S538 = _S566;
        _S542 = _S552;
        _S543 = _S549;
        _S544 = _S548;
        _S545 = _S518.value0_53.value0_52.alpha_1;
        _S539 = _S546;
        _S540 = _S547;
    }
    else
    {
        _runFlag_4 = false;
        _S526 = false;
        _S528 = 0.0f;
        _S529 = 0.0f;
        _S530 = 0.0f;
        _S531 = 0.0f;
        _S532 = 0.0f;
        _S533 = 0.0f;
        _S541.value0_57 = _S523;
        _S534 = 0.0f;
        _S535 = 0.0f;
        _S527 = false;
        _S536 = 0.0f;
        _S537 = 0.0f;
        _S538 = 0.0f;
        _S542._S35 = _S522;
        _S542._S36 = _S522;
        _S543 = _S522;
        _S544 = _S522;
        _S545 = _S522;
        _S539 = 0.0f;
        _S540 = 0.0f;
    }
    var _S567 : Microfacets_Differential_0 = Microfacets_x24_syn_dzero_0();
    var _S568 : vec3<f32> = vec3<f32>(0.0f);
    var _S569 : vec3<f32>;
    var _S570 : Microfacets_Differential_0;
    if(_S525)
    {
        if(_runFlag_4)
        {
            if(_S526)
            {
                _S528 = 0.0f;
                _S529 = 0.0f;
                _S530 = 0.0f;
            }
            else
            {
                var _S571 : f32 = _S521 / _S528;
                var _S572 : f32 = _S529 * - _S571;
                var _S573 : f32 = _S530 * _S571;
                var _S574 : f32 = _S531 * _S572;
                var _S575 : f32 = _S532 * _S572;
                var _S576 : f32 = _S533 * _S575;
                var _S577 : f32 = _S532 * _S575;
                var _S578 : f32 = 0.0f;
                s_bwdProp_exponential_0(_S541, &(_S578), _S573);
                var _S579 : f32 = _S574 + _S576;
                _S528 = - _S578;
                _S529 = _S579;
                _S530 = _S577;
            }
            var _S580 : f32 = _S528 / _S534;
            var _S581 : f32 = _S532 * _S580;
            var _S582 : f32 = _S535 * - _S580 + _S529;
            _S528 = 0.0f;
            _S529 = _S530;
            _S530 = _S581;
            _S531 = _S582;
        }
        else
        {
            _S528 = _S521;
            _S529 = 0.0f;
            _S530 = 0.0f;
            _S531 = 0.0f;
        }
        if(_S527)
        {
            var _S583 : f32 = - (_S528 / _S536);
            var _S584 : f32 = _S538 * _S583;
            var _S585 : f32 = _S537 * _S583 + _S533 * _S584;
            var _S586 : f32 = _S538 * _S584 + _S529;
            var _S587 : f32 = _S585 + _S530;
            _S528 = _S585 + _S531;
            _S529 = _S587;
            _S530 = _S586;
        }
        else
        {
            var _S588 : f32 = _S529;
            _S528 = _S531;
            _S529 = _S530;
            _S530 = _S588;
        }
        var _S589 : f32 = _S524 * _S528;
        var _S590 : vec2<f32> = _S522;
        var _S591 : vec2<f32> = _S522;
        s_bwdProp_dot_0(_S542, &(_S590), &(_S591), _S529);
        var _S592 : vec2<f32> = (_S590 + _S591) / _S543;
        var _S593 : vec2<f32> = _S545 * _S592;
        var _S594 : vec2<f32> = _S544 * (vec2<f32>(0) - _S592) + vec2<f32>(3.14159274101257324f * (_S540 * _S530), _S539 * _S530);
        var _S595 : f32 = _S589 + _S589;
        var _S596 : vec3<f32> = vec3<f32>(_S593[i32(0)], _S593[i32(1)], 0.0f);
        var _S597 : Microfacets_Differential_0 = _S567;
        _S597.alpha_2 = _S594;
        var _S598 : Microfacets_Differential_0 = Microfacets_x24_syn_dadd_0(_S567, _S597);
        _S528 = _S595;
        _S569 = _S596;
        _S570 = _S598;
    }
    else
    {
        _S528 = 0.0f;
        _S569 = _S568;
        _S570 = _S567;
    }
    var _S599 : vec3<f32> = _S569 + vec3<f32>(0.0f, 0.0f, _S528);
    (*_S519) = _S570;
    (*_S520) = _S599;
    return;
}

fn s_bwdProp_mirrored_0( _S600 : s_bwdCallableCtx_mirrored_0,  _S601 : ptr<function, Microfacets_Differential_0>,  _S602 : ptr<function, vec3<f32>>,  _S603 : ptr<function, vec3<f32>>,  _S604 : Mirrored_0)
{
    var _S605 : vec3<f32> = _S600.value0_39.value1_8 + _S600.value0_39.value2_2;
    var _S606 : Tuple_5 = s_apply_normalize_0(_S605);
    var _S607 : s_bwdCallableCtx_normalize_0;
    _S607._S49 = _S605;
    var _S608 : s_bwdCallableCtx_dot_1;
    _S608._S44 = _S600.value0_39.value1_8;
    _S608._S45 = _S606.value0_7;
    var _S609 : Tuple_12 = s_apply_density_0(_S600.value0_39.value0_33, _S606.value0_7);
    var _S610 : s_paramCtx_s_bwdCallableCtx_density_0;
    _S610.value0_52 = _S600.value0_39.value0_33;
    _S610.value1_16 = _S606.value0_7;
    var _S611 : s_bwdCallableCtx_density_0 = s_bwdCallableCtx_density_0( _S610 );
    var _S612 : f32 = 0.25f * _S609.value0_19;
    var _S613 : Tuple_14 = s_apply_visible_over_cos_0(_S600.value0_39.value0_33, _S600.value0_39.value1_8);
    var _S614 : s_paramCtx_s_bwdCallableCtx_visible_over_cos_0;
    _S614.value0_54 = _S600.value0_39.value0_33;
    _S614.value1_17 = _S600.value0_39.value1_8;
    var _S615 : s_bwdCallableCtx_visible_over_cos_0 = s_bwdCallableCtx_visible_over_cos_0( _S614 );
    var _S616 : f32 = _S612 * _S613.value0_21;
    var _S617 : Tuple_14 = s_apply_visible_over_cos_0(_S600.value0_39.value0_33, _S600.value0_39.value2_2);
    var _S618 : s_paramCtx_s_bwdCallableCtx_visible_over_cos_0;
    _S618.value0_54 = _S600.value0_39.value0_33;
    _S618.value1_17 = _S600.value0_39.value2_2;
    var _S619 : s_bwdCallableCtx_visible_over_cos_0 = s_bwdCallableCtx_visible_over_cos_0( _S618 );
    var _S620 : Microfacets_Differential_0 = Microfacets_x24_syn_dzero_0();
    var _S621 : f32 = _S616 * _S617.value0_21 * _S604.scattered_0;
    var _S622 : f32 = _S600.value0_39.value2_2.z * _S604.scattered_0;
    var _S623 : f32 = _S616 * _S622;
    var _S624 : f32 = _S617.value0_21 * _S622;
    var _S625 : vec2<f32> = vec2<f32>(0.0f);
    var _S626 : Microfacets_Differential_0;
    _S626.alpha_2 = _S625;
    var _S627 : vec3<f32> = vec3<f32>(0.0f);
    var _S628 : vec3<f32> = _S627;
    s_bwdProp_visible_over_cos_0(_S619, &(_S626), &(_S628), _S623);
    var _S629 : f32 = _S604.pdf_1 + _S624;
    var _S630 : f32 = _S612 * _S629;
    var _S631 : f32 = _S613.value0_21 * _S629;
    var _S632 : Microfacets_Differential_0;
    _S632.alpha_2 = _S625;
    var _S633 : vec3<f32> = _S627;
    s_bwdProp_visible_over_cos_0(_S615, &(_S632), &(_S633), _S630);
    var _S634 : f32 = 0.25f * _S631;
    var _S635 : Microfacets_Differential_0;
    _S635.alpha_2 = _S625;
    var _S636 : vec3<f32> = _S627;
    s_bwdProp_density_0(_S611, &(_S635), &(_S636), _S634);
    var _S637 : vec3<f32> = _S627;
    var _S638 : vec3<f32> = _S627;
    s_bwdProp_dot_1(_S608, &(_S637), &(_S638), _S604.cosine_0);
    var _S639 : vec3<f32> = _S636 + _S638;
    var _S640 : vec3<f32> = _S627;
    s_bwdProp_normalize_0(_S607, &(_S640), _S639);
    var _S641 : vec3<f32> = _S633 + _S637 + _S640;
    var _S642 : vec3<f32> = _S628 + _S640 + vec3<f32>(0.0f, 0.0f, _S621);
    (*_S601) = Microfacets_x24_syn_dadd_0(Microfacets_x24_syn_dadd_0(Microfacets_x24_syn_dadd_0(_S626, _S632), _S635), _S620);
    (*_S602) = _S641;
    (*_S603) = _S642;
    return;
}

fn s_bwdProp_facets_of_0( _S643 : s_bwdCallableCtx_facets_of_0,  _S644 : ptr<function, Numbers_0>,  _S645 : Microfacets_Differential_0)
{
    var _S646 : vec2<f32> = vec2<f32>(0.00009999999747379f);
    var _S647 : s_bwdCallableCtx_max_0;
    _S647._S67 = _S643.value0_40.value0_32.alpha_0;
    _S647._S68 = _S646;
    var _S648 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S649 : vec2<f32> = vec2<f32>(0.0f);
    var _S650 : vec2<f32> = _S649;
    var _S651 : vec2<f32> = _S649;
    s_bwdProp_max_0(_S647, &(_S650), &(_S651), _S645.alpha_2);
    var _S652 : Numbers_0 = _S648;
    _S652.alpha_0 = _S650;
    (*_S644) = Numbers_x24_syn_dadd_0(_S648, _S652);
    return;
}

fn s_bwdProp_scattering_0( _S653 : s_bwdCallableCtx_scattering_0,  _S654 : ptr<function, Numbers_0>,  _S655 : ptr<function, vec3<f32>>,  _S656 : ptr<function, vec3<f32>>,  _S657 : Scattering_Differential_0)
{
    var _S658 : vec3<f32> = vec3<f32>(0.0f);
    var _S659 : vec2<f32> = vec2<f32>(0.0f);
    var _S660 : Numbers_0 = Numbers_0( _S658, _S658, _S658, _S658, _S659 );
    var _S661 : s_paramCtx_s_bwdCallableCtx_facets_of_0 = s_paramCtx_s_bwdCallableCtx_facets_of_0( _S660 );
    var _S662 : Microfacets_0 = Microfacets_0( u32(0), _S659 );
    var _S663 : s_paramCtx_s_bwdCallableCtx_mirrored_0 = s_paramCtx_s_bwdCallableCtx_mirrored_0( _S662, _S658, _S658 );
    var _S664 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0 = s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0( 0.0f, _S658, _S658 );
    var _S665 : s_paramCtx_s_bwdCallableCtx_coat_eta_0 = s_paramCtx_s_bwdCallableCtx_coat_eta_0( _S660 );
    var _S666 : Lobe_0 = Lobe_0( u32(0), u32(0), u32(0), _S660 );
    var _S667 : s_paramCtx_s_bwdCallableCtx_transmittance_0 = s_paramCtx_s_bwdCallableCtx_transmittance_0( _S666, 0.0f, 0.0f );
    var _S668 : s_minCtx_s_bwdCallableCtx_transmittance_0 = s_minCtx_s_bwdCallableCtx_transmittance_0( 0.0f, 0.0f );
    var _S669 : s_paramCtx_s_bwdCallableCtx_base_0 = s_paramCtx_s_bwdCallableCtx_base_0( _S666, 0.0f, _S658 );
    var _S670 : s_minCtx_s_bwdCallableCtx_base_0 = s_minCtx_s_bwdCallableCtx_base_0( 0.0f, u32(0) );
    var _S671 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0 = s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0( 0.0f, 0.0f );
    var _S672 : f32 = _S653.value0_31.value3_1.z;
    var by_cosine_1 : f32 = _S672 * 0.31830987334251404f;
    var _S673 : vec3<f32> = vec3<f32>(by_cosine_1);
    var _S674 : bool = (_S653.value0_31.value0_30.kind_0) == u32(0);
    var _S675 : vec3<f32>;
    if(_S674)
    {
        _S675 = _S653.value0_31.value1_6.diffuse_reflectance_0;
    }
    else
    {
        _S675 = _S658;
    }
    var _S676 : bool = !_S674;
    var _S677 : vec3<f32>;
    var _S678 : vec3<f32>;
    var _S679 : vec3<f32>;
    var _S680 : vec3<f32>;
    var _S681 : vec3<f32>;
    var _S682 : vec3<f32>;
    var _S683 : vec3<f32>;
    var by_facets_1 : Mirrored_0;
    var _S684 : s_bwdCallableCtx_mirrored_0;
    var _S685 : s_bwdCallableCtx_facets_of_0;
    var _runFlag_5 : bool;
    var _S686 : bool;
    var _S687 : bool;
    var _S688 : bool;
    var _S689 : s_bwdCallableCtx_fresnel_conductor_0;
    var _S690 : f32;
    var _S691 : f32;
    var _S692 : f32;
    var _S693 : f32;
    var _S694 : f32;
    var _S695 : f32;
    var _S696 : f32;
    var _S697 : f32;
    var _S698 : f32;
    var _S699 : s_bwdCallableCtx_fresnel_dielectric_0;
    var _S700 : s_bwdCallableCtx_base_0;
    var _S701 : s_bwdCallableCtx_transmittance_0;
    var _S702 : s_bwdCallableCtx_transmittance_0;
    var _S703 : s_bwdCallableCtx_coat_eta_0;
    if(_S676)
    {
        var _S704 : Tuple_9 = s_apply_Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
        var _S705 : bool = is_rough_0(_S653.value0_31.value0_30);
        if(_S705)
        {
            var _S706 : Tuple_10 = s_apply_facets_of_0(_S653.value0_31.value0_30, _S653.value0_31.value1_6);
            var _S707 : s_paramCtx_s_bwdCallableCtx_facets_of_0;
            _S707.value0_32 = _S653.value0_31.value1_6;
            var _S708 : Tuple_11 = s_apply_mirrored_0(_S706.value0_17, _S653.value0_31.value2_1, _S653.value0_31.value3_1);
            var _S709 : s_paramCtx_s_bwdCallableCtx_mirrored_0;
            _S709.value0_33 = _S706.value0_17;
            _S709.value1_8 = _S653.value0_31.value2_1;
            _S709.value2_2 = _S653.value0_31.value3_1;
            by_facets_1 = _S708.value0_18;
            _S684.value0_39 = _S709;
            _S685.value0_40 = _S707;
        }
        else
        {
            by_facets_1 = _S704.value0_16;
            _S684.value0_39 = _S663;
            _S685.value0_40 = _S661;
        }
        var _S710 : bool = (_S653.value0_31.value0_30.kind_0) == u32(2);
        if(_S710)
        {
            var _S711 : Tuple_15 = s_apply_fresnel_conductor_0(by_facets_1.cosine_0, _S653.value0_31.value1_6.eta_0, _S653.value0_31.value1_6.k_0);
            var _S712 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0;
            _S712.value0_34 = by_facets_1.cosine_0;
            _S712.value1_9 = _S653.value0_31.value1_6.eta_0;
            _S712.value2_3 = _S653.value0_31.value1_6.k_0;
            var _S713 : vec3<f32> = vec3<f32>(by_facets_1.scattered_0);
            var _S714 : vec3<f32> = _S711.value0_22 * _S713;
            _runFlag_5 = false;
            _S677 = _S653.value0_31.value1_6.specular_reflectance_0;
            _S678 = _S714;
            _S679 = _S711.value0_22;
            _S680 = _S713;
            _S689.value0_41 = _S712;
        }
        else
        {
            _runFlag_5 = _S676;
            _S677 = _S658;
            _S678 = _S658;
            _S679 = _S658;
            _S680 = _S658;
            _S689.value0_41 = _S664;
        }
        if(_runFlag_5)
        {
            var _S715 : Tuple_17 = s_apply_coat_eta_0(_S653.value0_31.value1_6);
            var _S716 : s_paramCtx_s_bwdCallableCtx_coat_eta_0;
            _S716.value0_35 = _S653.value0_31.value1_6;
            var _S717 : s_paramCtx_s_bwdCallableCtx_coat_eta_0 = _S716;
            var _S718 : f32 = _S653.value0_31.value2_1.z;
            var _S719 : s_paramCtx_s_bwdCallableCtx_transmittance_0;
            _S719.value0_36 = _S653.value0_31.value0_30;
            _S719.value1_10 = _S715.value0_24;
            _S719.value2_4 = _S718;
            var _S720 : s_paramCtx_s_bwdCallableCtx_transmittance_0 = _S719;
            var _S721 : s_paramCtx_s_bwdCallableCtx_transmittance_0;
            _S721.value0_36 = _S653.value0_31.value0_30;
            _S721.value1_10 = _S715.value0_24;
            _S721.value2_4 = _S672;
            var _S722 : s_paramCtx_s_bwdCallableCtx_transmittance_0 = _S721;
            var _S723 : s_paramCtx_s_bwdCallableCtx_base_0;
            _S723.value0_37 = _S653.value0_31.value0_30;
            _S723.value1_11 = _S715.value0_24;
            _S723.value2_5 = _S653.value0_31.value1_6.diffuse_reflectance_0;
            var _S724 : s_paramCtx_s_bwdCallableCtx_base_0 = _S723;
            var _S725 : f32 = _S653.value1_7.value0_14 * _S653.value1_7.value2_0;
            var _S726 : f32 = _S725 * by_cosine_1;
            var _S727 : f32 = _S715.value0_24 * _S715.value0_24;
            var _S728 : vec3<f32> = vec3<f32>((_S726 / _S727));
            var _S729 : f32 = _S727 * _S727;
            var probability_1 : f32 = base_probability_0(_S653.value0_31.value1_6, _S653.value1_7.value0_14);
            var _S730 : bool = (_S653.value0_31.value0_30.kind_0) == u32(4);
            if(_S730)
            {
                var _S731 : Tuple_20 = s_apply_fresnel_dielectric_0(by_facets_1.cosine_0, _S715.value0_24);
                var _S732 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0;
                _S732.value0_38 = by_facets_1.cosine_0;
                _S732.value1_12 = _S715.value0_24;
                var _S733 : vec3<f32> = vec3<f32>((_S731.value0_27 * by_facets_1.scattered_0));
                _S690 = 1.0f - probability_1;
                _S681 = _S653.value0_31.value1_6.specular_reflectance_0;
                _S682 = _S733;
                _S691 = _S731.value0_27;
                _S692 = by_facets_1.scattered_0;
                _S699.value0_42 = _S732;
            }
            else
            {
                _S690 = 0.0f;
                _S681 = _S658;
                _S682 = _S658;
                _S691 = 0.0f;
                _S692 = 0.0f;
                _S699.value0_42 = _S671;
            }
            _S686 = _S730;
            _S693 = probability_1;
            _S683 = _S728;
            _S694 = _S729;
            _S695 = _S726;
            _S696 = _S727;
            _S697 = _S715.value0_24;
            _S698 = _S725;
            _S700.value0_43 = _S724;
            _S700.value1_13 = _S653.value1_7.value5_0;
            _S701.value0_44 = _S722;
            _S701.value1_14 = _S653.value1_7.value3_0;
            _S702.value0_44 = _S720;
            _S702.value1_14 = _S653.value1_7.value1_2;
            _S703.value0_45 = _S717;
        }
        else
        {
            _S686 = false;
            _S690 = 0.0f;
            _S681 = _S658;
            _S682 = _S658;
            _S691 = 0.0f;
            _S692 = 0.0f;
            _S699.value0_42 = _S671;
            _S693 = 0.0f;
            _S683 = _S658;
            _S694 = 0.0f;
            _S695 = 0.0f;
            _S696 = 0.0f;
            _S697 = 0.0f;
            _S698 = 0.0f;
            _S700.value0_43 = _S669;
            _S700.value1_13 = _S670;
            _S701.value0_44 = _S667;
            _S701.value1_14 = _S668;
            _S702.value0_44 = _S667;
            _S702.value1_14 = _S668;
            _S703.value0_45 = _S665;
        }
        var _S734 : vec3<f32> = _S677;
        var _S735 : vec3<f32> = _S678;
        var _S736 : vec3<f32> = _S679;
        var _S737 : vec3<f32> = _S680;
        _S677 = _S681;
        _S678 = _S682;
        _S679 = _S683;
        _S687 = _S710;
        _S680 = _S734;
        _S681 = _S735;
        _S682 = _S736;
        _S683 = _S737;
        _S688 = _S705;
    }
    else
    {
        _runFlag_5 = false;
        _S686 = false;
        _S690 = 0.0f;
        _S677 = _S658;
        _S678 = _S658;
        _S691 = 0.0f;
        _S692 = 0.0f;
        _S699.value0_42 = _S671;
        _S693 = 0.0f;
        _S679 = _S658;
        _S694 = 0.0f;
        _S695 = 0.0f;
        _S696 = 0.0f;
        _S697 = 0.0f;
        _S698 = 0.0f;
        _S700.value0_43 = _S669;
        _S700.value1_13 = _S670;
        _S701.value0_44 = _S667;
        _S701.value1_14 = _S668;
        _S702.value0_44 = _S667;
        _S702.value1_14 = _S668;
        _S703.value0_45 = _S665;
        _S687 = false;
        _S680 = _S658;
        _S681 = _S658;
        _S682 = _S658;
        _S683 = _S658;
        _S689.value0_41 = _S664;
        _S688 = false;
        _S684.value0_39 = _S663;
        _S685.value0_40 = _S661;
    }
    var _S738 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S739 : Mirrored_0 = Mirrored_x24_syn_dzero_0();
    var _S740 : Scattering_Differential_0 = Scattering_x24_syn_dzero_0();
    var _S741 : Scattering_Differential_0 = Scattering_x24_syn_dadd_0(_S657, _S740);
    var _S742 : Scattering_Differential_0;
    var _S743 : Numbers_0;
    if(_S676)
    {
        if(_runFlag_5)
        {
            if(_S686)
            {
                var _S744 : f32 = _S690 * 0.0f;
                var _S745 : vec3<f32> = _S677 * _S741.value_0;
                var _S746 : vec3<f32> = _S678 * _S741.value_0;
                var _S747 : f32 = _S745[i32(0)] + _S745[i32(1)] + _S745[i32(2)];
                var _S748 : f32 = _S691 * _S747;
                var _S749 : f32 = _S692 * _S747;
                var _S750 : f32 = 0.0f;
                var _S751 : f32 = 0.0f;
                s_bwdProp_fresnel_dielectric_0(_S699, &(_S750), &(_S751), _S749);
                var _S752 : Mirrored_0 = _S739;
                _S752.pdf_1 = _S744;
                _S752.scattered_0 = _S748;
                _S752.cosine_0 = _S750;
                var _S753 : Mirrored_0 = Mirrored_x24_syn_dadd_0(_S739, _S752);
                var _S754 : Numbers_0 = _S738;
                _S754.specular_reflectance_0 = _S746;
                var _S755 : Numbers_0 = Numbers_x24_syn_dadd_0(_S738, _S754);
                _S742 = _S740;
                _S677 = _S741.value_0;
                _S690 = _S751;
                _S743 = _S755;
                by_facets_1 = _S753;
            }
            else
            {
                _S742 = Scattering_x24_syn_dadd_0(_S741, _S740);
                _S677 = _S658;
                _S690 = 0.0f;
                _S743 = _S738;
                by_facets_1 = _S739;
            }
            var _S756 : f32 = _S693 * 0.0f;
            var _S757 : vec3<f32> = _S742.value_0 + _S677;
            var _S758 : vec3<f32> = _S653.value1_7.value4_0 * _S757;
            var _S759 : vec3<f32> = _S679 * _S757;
            var _S760 : f32 = (_S758[i32(0)] + _S758[i32(1)] + _S758[i32(2)]) / _S694;
            var _S761 : f32 = _S696 * _S760;
            var _S762 : f32 = _S697 * (_S695 * - _S760);
            var _S763 : f32 = _S698 * _S761;
            var _S764 : f32 = by_cosine_1 * _S761;
            var _S765 : f32 = _S653.value1_7.value0_14 * _S764;
            var _S766 : f32 = _S653.value1_7.value2_0 * _S764;
            var _S767 : f32 = 0.0f;
            var _S768 : vec3<f32> = _S658;
            s_bwdProp_base_0(_S700, &(_S767), &(_S768), _S759);
            var _S769 : f32 = 0.0f;
            var _S770 : f32 = 0.0f;
            s_bwdProp_transmittance_0(_S701, &(_S769), &(_S770), _S765);
            var _S771 : f32 = 0.0f;
            var _S772 : f32 = 0.0f;
            s_bwdProp_transmittance_0(_S702, &(_S771), &(_S772), _S766);
            var _S773 : f32 = _S762 + _S762 + _S767 + _S769 + _S771 + _S690;
            var _S774 : Numbers_0;
            _S774.diffuse_reflectance_0 = _S658;
            _S774.specular_reflectance_0 = _S658;
            _S774.eta_0 = _S658;
            _S774.k_0 = _S658;
            _S774.alpha_0 = _S659;
            s_bwdProp_coat_eta_0(_S703, &(_S774), _S773);
            var _S775 : f32 = _S756 + _S763;
            var _S776 : vec3<f32> = vec3<f32>(0.0f, 0.0f, _S772);
            var _S777 : Numbers_0 = Numbers_x24_syn_dadd_0(_S774, _S743);
            var _S778 : Numbers_0 = _S738;
            _S778.diffuse_reflectance_0 = _S768;
            var _S779 : Numbers_0 = Numbers_x24_syn_dadd_0(_S777, _S778);
            _S742 = _S740;
            _S743 = _S779;
            _S677 = _S776;
            _S690 = _S775;
            _S691 = _S770;
        }
        else
        {
            _S742 = Scattering_x24_syn_dadd_0(_S741, _S740);
            by_facets_1 = _S739;
            _S743 = _S738;
            _S677 = _S658;
            _S690 = 0.0f;
            _S691 = 0.0f;
        }
        if(_S687)
        {
            var _S780 : vec3<f32> = _S680 * _S742.value_0;
            var _S781 : vec3<f32> = _S681 * _S742.value_0;
            var _S782 : vec3<f32> = _S682 * _S780;
            var _S783 : vec3<f32> = _S683 * _S780;
            var _S784 : f32 = _S782[i32(0)] + _S782[i32(1)] + _S782[i32(2)];
            var _S785 : f32 = 0.0f;
            var _S786 : vec3<f32> = _S658;
            var _S787 : vec3<f32> = _S658;
            s_bwdProp_fresnel_conductor_0(_S689, &(_S785), &(_S786), &(_S787), _S783);
            var _S788 : Mirrored_0 = _S739;
            _S788.pdf_1 = 0.0f;
            _S788.scattered_0 = _S784;
            _S788.cosine_0 = _S785;
            var _S789 : Mirrored_0 = Mirrored_x24_syn_dadd_0(by_facets_1, _S788);
            var _S790 : Numbers_0 = _S738;
            _S790.specular_reflectance_0 = _S781;
            _S790.k_0 = _S787;
            _S790.eta_0 = _S786;
            var _S791 : Numbers_0 = Numbers_x24_syn_dadd_0(_S743, _S790);
            by_facets_1 = _S789;
            _S743 = _S791;
            _S742 = _S740;
        }
        else
        {
            _S742 = Scattering_x24_syn_dadd_0(_S742, _S740);
        }
        if(_S688)
        {
            var _S792 : Microfacets_Differential_0;
            _S792.alpha_2 = _S659;
            var _S793 : vec3<f32> = _S658;
            var _S794 : vec3<f32> = _S658;
            s_bwdProp_mirrored_0(_S684, &(_S792), &(_S793), &(_S794), by_facets_1);
            var _S795 : Numbers_0;
            _S795.diffuse_reflectance_0 = _S658;
            _S795.specular_reflectance_0 = _S658;
            _S795.eta_0 = _S658;
            _S795.k_0 = _S658;
            _S795.alpha_0 = _S659;
            s_bwdProp_facets_of_0(_S685, &(_S795), _S792);
            var _S796 : vec3<f32> = _S793 + _S677;
            _S743 = Numbers_x24_syn_dadd_0(_S795, _S743);
            _S677 = _S794;
            _S678 = _S796;
        }
        else
        {
            var _S797 : vec3<f32> = _S677;
            _S677 = _S658;
            _S678 = _S797;
        }
    }
    else
    {
        _S742 = Scattering_x24_syn_dadd_0(_S741, _S740);
        _S743 = _S738;
        _S690 = 0.0f;
        _S691 = 0.0f;
        _S677 = _S658;
        _S678 = _S658;
    }
    if(_S674)
    {
        var _S798 : vec3<f32> = _S675 * _S742.value_0;
        var _S799 : vec3<f32> = _S673 * _S742.value_0;
        var _S800 : Numbers_0 = _S738;
        _S800.diffuse_reflectance_0 = _S799;
        var _S801 : Numbers_0 = Numbers_x24_syn_dadd_0(_S743, _S800);
        _S675 = _S798;
        _S743 = _S801;
    }
    else
    {
        _S675 = _S658;
    }
    var _S802 : vec3<f32> = _S677 + vec3<f32>(0.0f, 0.0f, 0.31830987334251404f * (_S675[i32(0)] + _S675[i32(1)] + _S675[i32(2)] + _S690) + _S691);
    (*_S654) = _S743;
    (*_S655) = _S678;
    (*_S656) = _S802;
    return;
}

fn _S803( _S804 : Lobe_0,  _S805 : ptr<function, DiffPair_Numbers_0>,  _S806 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S807 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S808 : Scattering_Differential_0)
{
    var _S809 : Tuple_8 = s_apply_scattering_0(_S804, (*_S805).primal_0, (*_S806).primal_0, (*_S807).primal_0);
    var _S810 : s_paramCtx_s_bwdCallableCtx_scattering_0;
    _S810.value0_30 = _S804;
    _S810.value1_6 = (*_S805).primal_0;
    _S810.value2_1 = (*_S806).primal_0;
    _S810.value3_1 = (*_S807).primal_0;
    var _S811 : s_bwdCallableCtx_scattering_0 = s_bwdCallableCtx_scattering_0( _S810, _S809.value1_3 );
    var _S812 : Numbers_0 = (*_S805).differential_0;
    var _S813 : vec3<f32> = (*_S806).differential_0;
    var _S814 : vec3<f32> = (*_S807).differential_0;
    s_bwdProp_scattering_0(_S811, &(_S812), &(_S813), &(_S814), _S808);
    (*_S805).differential_0 = _S812;
    (*_S806).differential_0 = _S813;
    (*_S807).differential_0 = _S814;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_specular_fraction_0
{
     value0_58 : Lobe_0,
     value1_18 : Numbers_0,
     value2_7 : vec3<f32>,
};

struct s_bwdCallableCtx_specular_fraction_0
{
     value0_59 : s_paramCtx_s_bwdCallableCtx_specular_fraction_0,
};

fn s_bwdProp_specular_fraction_0( _S815 : s_bwdCallableCtx_specular_fraction_0,  _S816 : ptr<function, Numbers_0>,  _S817 : ptr<function, vec3<f32>>,  _S818 : vec3<f32>)
{
    var _S819 : vec3<f32> = vec3<f32>(0.0f);
    var _S820 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0 = s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0( 0.0f, _S819, _S819 );
    var _S821 : vec2<f32> = vec2<f32>(0.0f);
    var _S822 : Numbers_0 = Numbers_0( _S819, _S819, _S819, _S819, _S821 );
    var _S823 : s_paramCtx_s_bwdCallableCtx_coat_eta_0 = s_paramCtx_s_bwdCallableCtx_coat_eta_0( _S822 );
    var _S824 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0 = s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0( 0.0f, 0.0f );
    var _S825 : bool = (_S815.value0_59.value0_58.kind_0) == u32(1);
    var _S826 : vec3<f32>;
    var _S827 : vec3<f32>;
    var _S828 : s_bwdCallableCtx_fresnel_conductor_0;
    if(_S825)
    {
        var _S829 : f32 = _S815.value0_59.value2_7.z;
        var _S830 : Tuple_15 = s_apply_fresnel_conductor_0(_S829, _S815.value0_59.value1_18.eta_0, _S815.value0_59.value1_18.k_0);
        var _S831 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0;
        _S831.value0_34 = _S829;
        _S831.value1_9 = _S815.value0_59.value1_18.eta_0;
        _S831.value2_3 = _S815.value0_59.value1_18.k_0;
        _S826 = _S815.value0_59.value1_18.specular_reflectance_0;
        _S827 = _S830.value0_22;
        _S828.value0_41 = _S831;
    }
    else
    {
        _S826 = _S819;
        _S827 = _S819;
        _S828.value0_41 = _S820;
    }
    var _S832 : bool = !_S825;
    var _S833 : vec3<f32>;
    var _S834 : vec3<f32>;
    var _S835 : s_bwdCallableCtx_fresnel_dielectric_0;
    var _S836 : s_bwdCallableCtx_coat_eta_0;
    if(_S832)
    {
        var _S837 : f32 = _S815.value0_59.value2_7.z;
        var _S838 : Tuple_17 = s_apply_coat_eta_0(_S815.value0_59.value1_18);
        var _S839 : s_paramCtx_s_bwdCallableCtx_coat_eta_0;
        _S839.value0_35 = _S815.value0_59.value1_18;
        var _S840 : vec3<f32> = vec3<f32>(s_apply_fresnel_dielectric_0(_S837, _S838.value0_24).value0_27);
        var _S841 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0;
        _S841.value0_38 = _S837;
        _S841.value1_12 = _S838.value0_24;
        _S833 = _S815.value0_59.value1_18.specular_reflectance_0;
        _S834 = _S840;
        _S835.value0_42 = _S841;
        _S836.value0_45 = _S839;
    }
    else
    {
        _S833 = _S819;
        _S834 = _S819;
        _S835.value0_42 = _S824;
        _S836.value0_45 = _S823;
    }
    var _S842 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S843 : Numbers_0;
    if(_S832)
    {
        var _S844 : vec3<f32> = _S833 * _S818;
        var _S845 : vec3<f32> = _S834 * _S818;
        var _S846 : f32 = _S844[i32(0)] + _S844[i32(1)] + _S844[i32(2)];
        var _S847 : f32 = 0.0f;
        var _S848 : f32 = 0.0f;
        s_bwdProp_fresnel_dielectric_0(_S835, &(_S847), &(_S848), _S846);
        var _S849 : Numbers_0;
        _S849.diffuse_reflectance_0 = _S819;
        _S849.specular_reflectance_0 = _S819;
        _S849.eta_0 = _S819;
        _S849.k_0 = _S819;
        _S849.alpha_0 = _S821;
        s_bwdProp_coat_eta_0(_S836, &(_S849), _S848);
        var _S850 : vec3<f32> = vec3<f32>(0.0f, 0.0f, _S847);
        var _S851 : Numbers_0 = Numbers_x24_syn_dadd_0(_S849, _S842);
        var _S852 : Numbers_0 = _S842;
        _S852.specular_reflectance_0 = _S845;
        var _S853 : Numbers_0 = Numbers_x24_syn_dadd_0(_S851, _S852);
        _S833 = _S819;
        _S834 = _S850;
        _S843 = _S853;
    }
    else
    {
        _S833 = _S818;
        _S834 = _S819;
        _S843 = _S842;
    }
    if(_S825)
    {
        var _S854 : vec3<f32> = _S826 * _S833;
        var _S855 : vec3<f32> = _S827 * _S833;
        var _S856 : f32 = 0.0f;
        var _S857 : vec3<f32> = _S819;
        var _S858 : vec3<f32> = _S819;
        s_bwdProp_fresnel_conductor_0(_S828, &(_S856), &(_S857), &(_S858), _S854);
        var _S859 : vec3<f32> = _S834 + vec3<f32>(0.0f, 0.0f, _S856);
        var _S860 : Numbers_0 = _S842;
        _S860.k_0 = _S858;
        _S860.eta_0 = _S857;
        _S860.specular_reflectance_0 = _S855;
        _S843 = Numbers_x24_syn_dadd_0(_S843, _S860);
        _S826 = _S859;
    }
    else
    {
        _S826 = _S834;
    }
    (*_S816) = _S843;
    (*_S817) = _S826;
    return;
}

fn _S861( _S862 : Lobe_0,  _S863 : ptr<function, DiffPair_Numbers_0>,  _S864 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S865 : vec3<f32>)
{
    var _S866 : s_paramCtx_s_bwdCallableCtx_specular_fraction_0;
    _S866.value0_58 = _S862;
    _S866.value1_18 = (*_S863).primal_0;
    _S866.value2_7 = (*_S864).primal_0;
    var _S867 : s_bwdCallableCtx_specular_fraction_0 = s_bwdCallableCtx_specular_fraction_0( _S866 );
    var _S868 : Numbers_0 = (*_S863).differential_0;
    var _S869 : vec3<f32> = (*_S864).differential_0;
    s_bwdProp_specular_fraction_0(_S867, &(_S868), &(_S869), _S865);
    (*_S863).differential_0 = _S868;
    (*_S864).differential_0 = _S869;
    return;
}

fn path_word_0( path_0 : u32,  which_0 : u32) -> u32
{
    return paths_0[which_0 * launch_0.room_0 + path_0];
}

fn path_vector_0( path_1 : u32,  which_1 : ptr<function, u32>) -> vec3<f32>
{
    var _S870 : u32 = (*which_1) + u32(3);
    (*which_1) = _S870;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_1, _S870 - u32(3)), path_word_0(path_1, _S870 - u32(2)), path_word_0(path_1, _S870 - u32(1))))));
}

fn path_vector_1( path_2 : u32,  which_2 : ptr<function, u32>) -> vec3<f32>
{
    var _S871 : u32 = (*which_2) + u32(3);
    (*which_2) = _S871;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_2, _S871 - u32(3)), path_word_0(path_2, _S871 - u32(2)), path_word_0(path_2, _S871 - u32(1))))));
}

fn path_changing_0( path_3 : u32,  which_3 : ptr<function, u32>) -> vec3<f32>
{
    var value_2 : vec3<f32> = path_vector_1(path_3, &((*which_3)));
    return value_2;
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
};

fn place_at_0( triangle_1 : u32,  v_1 : f32,  w_1 : f32) -> Place_0
{
    var place_2 : Place_0;
    place_2.triangle_0 = triangle_1;
    place_2.v_0 = v_1;
    place_2.w_0 = w_1;
    return place_2;
}

fn path_place_0( path_4 : u32,  which_4 : ptr<function, u32>) -> Place_0
{
    var _S872 : u32 = (*which_4) + u32(3);
    (*which_4) = _S872;
    return place_at_0(path_word_0(path_4, _S872 - u32(3)), (bitcast<f32>((path_word_0(path_4, _S872 - u32(2))))), (bitcast<f32>((path_word_0(path_4, _S872 - u32(1))))));
}

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_0 : vec3<f32>,
     place_3 : Place_0,
     key_0 : vec2<u32>,
     adjoint_0 : vec3<f32>,
};

fn load_0( number_of_path_0 : u32) -> Path_0
{
    var at_3 : u32 = u32(1);
    var path_5 : Path_0;
    var _S873 : vec3<f32> = path_vector_0(number_of_path_0, &(at_3));
    path_5.adjoint_0 = _S873;
    var _S874 : vec3<f32> = path_changing_0(number_of_path_0, &(at_3));
    path_5.throughput_0 = _S874;
    var _S875 : vec3<f32> = path_changing_0(number_of_path_0, &(at_3));
    path_5.direction_0 = _S875;
    var _S876 : Place_0 = path_place_0(number_of_path_0, &(at_3));
    path_5.place_3 = _S876;
    path_5.key_0 = vec2<u32>(path_word_0(number_of_path_0, at_3), path_word_0(number_of_path_0, at_3 + u32(1)));
    return path_5;
}

fn changing_0( value_3 : vec3<f32>,  change_0 : vec3<f32>) -> vec3<f32>
{
    return value_3;
}

fn still_0( value_4 : vec3<f32>) -> vec3<f32>
{
    return changing_0(value_4, vec3<f32>(0.0f));
}

fn no_numbers_0() -> Numbers_0
{
    var numbers_2 : Numbers_0;
    var _S877 : vec3<f32> = vec3<f32>(0.0f);
    numbers_2.k_0 = _S877;
    numbers_2.eta_0 = _S877;
    numbers_2.specular_reflectance_0 = _S877;
    numbers_2.diffuse_reflectance_0 = _S877;
    numbers_2.alpha_0 = vec2<f32>(0.0f);
    return numbers_2;
}

struct Reflected_0
{
     direct_0 : vec3<f32>,
     onward_0 : vec3<f32>,
     wo_0 : vec3<f32>,
     is_specular_0 : bool,
     factor_0 : f32,
     by_emitters_0 : Numbers_0,
};

fn nothing_reflected_0() -> Reflected_0
{
    var reflected_0 : Reflected_0;
    var _S878 : vec3<f32> = still_0(vec3<f32>(0.0f));
    reflected_0.direct_0 = _S878;
    reflected_0.onward_0 = _S878;
    reflected_0.wo_0 = vec3<f32>(0.0f, 0.0f, 1.0f);
    reflected_0.is_specular_0 = false;
    reflected_0.factor_0 = 0.0f;
    reflected_0.by_emitters_0 = no_numbers_0();
    return reflected_0;
}

fn vertex_numbers_0( depth_1 : u32) -> u32
{
    return word_0(u32(7)) + depth_1 * (u32(3) * word_0(u32(2)) + u32(3) * word_0(u32(3)) + u32(1));
}

fn value_of_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0;
}

fn triangle_record_0( triangle_2 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_2;
}

fn shape_of_0( triangle_3 : u32) -> u32
{
    return word_0(u32(10)) + u32(6) * word_0(triangle_record_0(triangle_3));
}

fn primitive_vector_0( at_4 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_0[at_4], primitives_0[at_4 + u32(1)], primitives_0[at_4 + u32(2)]);
}

fn position_of_0( place_4 : Place_0) -> vec3<f32>
{
    var at_5 : u32 = u32(9) * place_4.triangle_0;
    var a_2 : vec3<f32> = primitive_vector_0(at_5);
    return a_2 + (primitive_vector_0(at_5 + u32(3)) - a_2) * vec3<f32>(place_4.v_0) + (primitive_vector_0(at_5 + u32(6)) - a_2) * vec3<f32>(place_4.w_0);
}

fn cross_of_0( triangle_4 : u32) -> vec3<f32>
{
    var at_6 : u32 = u32(9) * triangle_4;
    var a_3 : vec3<f32> = primitive_vector_0(at_6);
    return cross(primitive_vector_0(at_6 + u32(3)) - a_3, primitive_vector_0(at_6 + u32(6)) - a_3);
}

fn unit_0( v_2 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_2 / vec3<f32>(max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z))));
}

fn vector_at_0( at_7 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_7), number_0(at_7 + u32(1)), number_0(at_7 + u32(2)));
}

struct Surface_0
{
     place_5 : Place_0,
     shape_0 : u32,
     exact_0 : vec3<f32>,
     position_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     outward_0 : vec3<f32>,
     is_front_0 : bool,
};

fn surface_at_0( place_6 : Place_0,  direction_1 : vec3<f32>) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.place_5 = place_6;
    surface_0.shape_0 = shape_of_0(place_6.triangle_0);
    var _S879 : vec3<f32> = position_of_0(place_6);
    surface_0.exact_0 = _S879;
    surface_0.position_0 = _S879;
    var _S880 : vec3<f32> = unit_0(cross_of_0(place_6.triangle_0));
    surface_0.face_normal_0 = _S880;
    surface_0.outward_0 = _S880;
    var seen_0 : f32;
    if((dot(_S880, direction_1)) > 0.0f)
    {
        seen_0 = -1.0f;
    }
    else
    {
        seen_0 = 1.0f;
    }
    var normals_0 : u32 = word_0(surface_0.shape_0);
    if(normals_0 != u32(4294967295))
    {
        var record_1 : u32 = triangle_record_0(place_6.triangle_0) + u32(2);
        var a_4 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_1));
        var b_2 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_1 + u32(1)));
        var c_0 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_1 + u32(2)));
        if((dot(a_4 + b_2 + c_0, surface_0.face_normal_0)) < 0.0f)
        {
            seen_0 = - seen_0;
        }
        surface_0.outward_0 = normalize(a_4 + (b_2 - a_4) * vec3<f32>(place_6.v_0) + (c_0 - a_4) * vec3<f32>(place_6.w_0));
    }
    surface_0.is_front_0 = seen_0 > 0.0f;
    return surface_0;
}

fn material_of_0( surface_1 : Surface_0) -> u32
{
    var _S881 : u32;
    if(surface_1.is_front_0)
    {
        _S881 = u32(2);
    }
    else
    {
        _S881 = u32(3);
    }
    return word_0(surface_1.shape_0 + _S881);
}

struct Lookup_0
{
     count_0 : u32,
     texels_0 : vec4<u32>,
     weights_1 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_1 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    return lookup_0;
}

struct Corners2_0
{
     a_5 : vec2<f32>,
     b_3 : vec2<f32>,
     c_1 : vec2<f32>,
};

fn Corners2_x24init_0( a_6 : vec2<f32>,  b_4 : vec2<f32>,  c_2 : vec2<f32>) -> Corners2_0
{
    var _S882 : Corners2_0;
    _S882.a_5 = a_6;
    _S882.b_3 = b_4;
    _S882.c_1 = c_2;
    return _S882;
}

fn uvs_of_0( triangle_5 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f32>(0.0f), vec2<f32>(1.0f, 0.0f), vec2<f32>(0.0f, 1.0f));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_5) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_8 : u32 = uvs_at_0 + u32(6) * word_0(triangle_record_0(triangle_5) + u32(1));
    uvs_0.a_5 = vec2<f32>(number_0(at_8), number_0(at_8 + u32(1)));
    uvs_0.b_3 = vec2<f32>(number_0(at_8 + u32(2)), number_0(at_8 + u32(3)));
    uvs_0.c_1 = vec2<f32>(number_0(at_8 + u32(4)), number_0(at_8 + u32(5)));
    return uvs_0;
}

fn floor_of_0( x_11 : f32) -> i32
{
    return i32(floor(clamp(x_11, -1.0e+09f, 1.0e+09f)));
}

fn wrapped_0( i_0 : i32,  n_0 : i32,  wrap_0 : u32) -> u32
{
    if(wrap_0 == u32(2))
    {
        return u32(clamp(i_0, i32(0), n_0 - i32(1)));
    }
    var period_0 : i32;
    if(wrap_0 == u32(1))
    {
        period_0 = i32(2) * n_0;
    }
    else
    {
        period_0 = n_0;
    }
    var inside_0 : i32 = i_0 % period_0;
    var inside_1 : i32;
    if(inside_0 < i32(0))
    {
        inside_1 = inside_0 + period_0;
    }
    else
    {
        inside_1 = inside_0;
    }
    if(inside_1 < n_0)
    {
        period_0 = inside_1;
    }
    else
    {
        period_0 = i32(2) * n_0 - i32(1) - inside_1;
    }
    return u32(period_0);
}

struct Point_0
{
     value_5 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_7 : Point_0) -> Lookup_0
{
    var way_0 : vec2<f32> = place_7.value_5 - floor(place_7.value_5);
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_0;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S883 : f32 = back_0.x;
    var _S884 : f32 = back_0.y;
    var _S885 : f32 = way_0.x;
    var _S886 : f32 = way_0.y;
    lookup_1.weights_1 = vec4<f32>(_S883 * _S884, _S885 * _S884, _S883 * _S886, _S885 * _S886);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var place_8 : vec2<f32> = uv_0.value_5 * vec2<f32>(f32(width_0), f32(height_0));
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_8.y), height_0, wrap_1);
        var _S887 : u32 = row_0 * u32(width_0);
        var _S888 : u32 = wrapped_0(floor_of_0(place_8.x), width_0, wrap_1);
        return one_texel_0(_S887 + _S888);
    }
    var centred_0 : Point_0;
    var _S889 : vec2<f32> = place_8 - vec2<f32>(0.5f);
    centred_0.value_5 = _S889;
    var x_12 : i32 = floor_of_0(_S889.x);
    var y_3 : i32 = floor_of_0(_S889.y);
    var _S890 : u32 = wrapped_0(y_3, height_0, wrap_1);
    var _S891 : u32 = u32(width_0);
    var first_1 : u32 = _S890 * _S891;
    var _S892 : u32 = wrapped_0(y_3 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S892 * _S891;
    var left_0 : u32 = wrapped_0(x_12, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_12 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_9 : Place_0) -> Lookup_0
{
    var kind_1 : u32 = word_0(texture_1);
    if(kind_1 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_2 : u32 = triangle_record_0(place_9.triangle_0) + u32(1);
    if(kind_1 == u32(4))
    {
        return one_texel_0(word_0(record_2));
    }
    if(kind_1 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_2 + u32(1)), word_0(record_2 + u32(2)), word_0(record_2 + u32(3)), u32(0));
        lookup_2.weights_1 = vec4<f32>(1.0f - place_9.v_0 - place_9.w_0, place_9.v_0, place_9.w_0, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_9.triangle_0);
    var rows_0 : u32 = texture_1 + u32(6);
    var uv_1 : Point_0;
    var _S893 : vec3<f32> = vec3<f32>(uvs_1.a_5 * vec2<f32>((1.0f - place_9.v_0 - place_9.w_0)) + uvs_1.b_3 * vec2<f32>(place_9.v_0) + uvs_1.c_1 * vec2<f32>(place_9.w_0), 1.0f);
    uv_1.value_5 = vec2<f32>(dot(_S893, vector_at_0(rows_0)), dot(_S893, vector_at_0(rows_0 + u32(3))));
    if(kind_1 == u32(1))
    {
        var _S894 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S894;
    }
    var half_of_period_0 : vec2<f32> = uv_1.value_5 - floor(uv_1.value_5);
    var _S895 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S895 = i32(1);
    }
    else
    {
        _S895 = i32(0);
    }
    return one_texel_0(u32(_S895));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_2 : vec4<f32>) -> vec3<f32>
{
    var _S896 : u32 = word_0(texture_2 + u32(1));
    var _S897 : u32 = texture_2 + u32(13);
    var _S898 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_6 : vec3<f32> = _S898;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_9 : u32 = _S897 + _S896 * lookup_3.texels_0[k_1];
        var _S899 : vec3<f32>;
        if(_S896 == u32(1))
        {
            _S899 = vec3<f32>(number_0(at_9));
        }
        else
        {
            _S899 = vector_at_0(at_9);
        }
        var value_7 : vec3<f32> = value_6 + _S899 * vec3<f32>(weights_2[k_1]);
        k_1 = k_1 + u32(1);
        value_6 = value_7;
    }
    return value_6;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_1);
}

fn luminance_0( colour_1 : vec3<f32>) -> f32
{
    return dot(colour_1, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f));
}

fn set_slot_0( numbers_3 : ptr<function, Numbers_0>,  slot_0 : u32,  value_8 : vec3<f32>)
{
    switch(slot_0)
    {
    case u32(0):
        {
            (*numbers_3).diffuse_reflectance_0 = value_8;
            break;
        }
    case u32(1):
        {
            (*numbers_3).specular_reflectance_0 = value_8;
            break;
        }
    case u32(2):
        {
            (*numbers_3).eta_0 = value_8;
            break;
        }
    case u32(3):
        {
            (*numbers_3).k_0 = value_8;
            break;
        }
    case u32(4):
        {
            (*numbers_3).alpha_0[i32(0)] = luminance_0(value_8);
            break;
        }
    default :
        {
            (*numbers_3).alpha_0[i32(1)] = luminance_0(value_8);
            break;
        }
    }
    return;
}

fn lobe_at_0( record_3 : u32,  place_10 : Place_0) -> Lobe_0
{
    var lobe_5 : Lobe_0;
    lobe_5.record_0 = record_3;
    lobe_5.kind_0 = word_0(record_3);
    lobe_5.distribution_0 = word_0(record_3 + u32(1));
    lobe_5.numbers_0 = no_numbers_0();
    var _S900 : u32 = word_0(record_3 + u32(4));
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < _S900)
        {
        }
        else
        {
            break;
        }
        var texture_4 : u32 = word_0(record_3 + u32(5) + slot_1);
        if(texture_4 == u32(4294967295))
        {
            slot_1 = slot_1 + u32(1);
            continue;
        }
        var _S901 : Lookup_0 = lookup_at_0(texture_4, place_10);
        var _S902 : vec3<f32> = value_of_0(looked_up_0(texture_4, _S901));
        var _S903 : Numbers_0 = lobe_5.numbers_0;
        set_slot_0(&(_S903), slot_1, _S902);
        lobe_5.numbers_0 = _S903;
        slot_1 = slot_1 + u32(1);
    }
    return lobe_5;
}

struct Axes_0
{
     s_0 : vec3<f32>,
     t_0 : vec3<f32>,
     n_1 : vec3<f32>,
};

fn axes_of_0( n_2 : vec3<f32>,  tangent_0 : vec3<f32>,  is_front_1 : bool) -> Axes_0
{
    var axes_0 : Axes_0;
    var _S904 : vec3<f32>;
    if(is_front_1)
    {
        _S904 = n_2;
    }
    else
    {
        _S904 = (vec3<f32>(0) - n_2);
    }
    axes_0.n_1 = _S904;
    var across_0 : vec3<f32> = tangent_0 - n_2 * vec3<f32>(dot(n_2, tangent_0));
    if((dot(across_0, across_0)) > 0.0f)
    {
        var _S905 : vec3<f32> = normalize(across_0);
        axes_0.s_0 = _S905;
        axes_0.t_0 = cross(n_2, _S905);
        return axes_0;
    }
    var _S906 : f32 = n_2.z;
    var sign_0 : f32;
    if(_S906 < 0.0f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var a_7 : f32 = -1.0f / (sign_0 + _S906);
    var _S907 : f32 = n_2.x;
    var _S908 : f32 = n_2.y;
    var b_5 : f32 = _S907 * _S908 * a_7;
    axes_0.s_0 = vec3<f32>(1.0f + sign_0 * _S907 * _S907 * a_7, sign_0 * b_5, - sign_0 * _S907);
    axes_0.t_0 = vec3<f32>(b_5, sign_0 + _S908 * _S908 * a_7, - _S908);
    return axes_0;
}

fn to_local_0( axes_1 : Axes_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(axes_1.s_0, v_3), dot(axes_1.t_0, v_3), dot(axes_1.n_1, v_3));
}

fn towards_viewer_0( axes_2 : Axes_0,  direction_2 : vec3<f32>) -> vec3<f32>
{
    var wi_0 : vec3<f32> = (vec3<f32>(0) - to_local_0(axes_2, direction_2));
    return vec3<f32>(wi_0.x, wi_0.y, max(abs(wi_0.z), 9.999999960041972e-13f));
}

struct Vertex_0
{
     surface_2 : Surface_0,
     axes_3 : Axes_0,
     lobe_6 : Lobe_0,
     wi_1 : vec3<f32>,
};

fn vertex_at_0( surface_3 : Surface_0,  material_0 : u32,  direction_3 : vec3<f32>) -> Vertex_0
{
    var vertex_0 : Vertex_0;
    vertex_0.surface_2 = surface_3;
    var _S909 : Lobe_0 = lobe_at_0(material_0, surface_3.place_5);
    vertex_0.lobe_6 = _S909;
    var _S910 : vec3<f32> = vec3<f32>(0.0f);
    var tangents_0 : u32 = word_0(surface_3.shape_0 + u32(5));
    var tangent_1 : vec3<f32>;
    if(tangents_0 != u32(4294967295))
    {
        tangent_1 = vector_at_0(tangents_0 + u32(3) * word_0(triangle_record_0(surface_3.place_5.triangle_0) + u32(1)));
    }
    else
    {
        tangent_1 = _S910;
    }
    var _S911 : Axes_0 = axes_of_0(surface_3.outward_0, tangent_1, surface_3.is_front_0);
    vertex_0.axes_3 = _S911;
    vertex_0.wi_1 = towards_viewer_0(_S911, direction_3);
    return vertex_0;
}

fn reaches_0( segments_0 : u32) -> bool
{
    return segments_0 <= (word_0(u32(0)));
}

fn emitter_record_0( emitter_0 : u32) -> u32
{
    return word_0(u32(11)) + u32(12) * emitter_0;
}

fn is_area_0( record_4 : u32) -> bool
{
    return (word_0(record_4)) == u32(0);
}

fn node_seen_0( node_0 : u32,  viewpoint_0 : vec3<f32>) -> f32
{
    var offset_0 : vec3<f32> = viewpoint_0 - vector_at_0(node_0 + u32(4));
    var axis_0 : vec3<f32> = vector_at_0(node_0 + u32(12));
    var radius_0 : f32 = number_0(node_0 + u32(7));
    var area_0 : f32 = number_0(node_0 + u32(11));
    var cosine_spread_0 : f32 = number_0(node_0 + u32(15));
    var sine_spread_0 : f32 = number_0(node_0 + u32(16));
    var squared_2 : f32 = dot(offset_0, offset_0);
    var distance_0 : f32 = sqrt(squared_2);
    if(distance_0 <= radius_0)
    {
        return 0.25f * area_0 / max(radius_0 * radius_0, 1.00000000317107685e-30f);
    }
    var cosine_1 : f32 = clamp(dot(axis_0, offset_0) / distance_0, -1.0f, 1.0f);
    var sine_0 : f32 = sqrt(1.0f - cosine_1 * cosine_1);
    var tilt_0 : f32 = radius_0 / distance_0;
    var highest_0 : f32;
    if(cosine_1 >= cosine_spread_0)
    {
        highest_0 = 1.0f;
    }
    else
    {
        highest_0 = cosine_1 * cosine_spread_0 + sine_0 * sine_spread_0 + tilt_0;
    }
    var lowest_0 : f32;
    if(cosine_1 <= (- cosine_spread_0))
    {
        lowest_0 = -1.0f;
    }
    else
    {
        lowest_0 = cosine_1 * cosine_spread_0 - sine_0 * sine_spread_0 - tilt_0;
    }
    if(highest_0 <= 0.0f)
    {
        return 0.0f;
    }
    if(lowest_0 >= 0.0f)
    {
        return max(dot(vector_at_0(node_0 + u32(8)), offset_0) / distance_0, 0.0f) / squared_2;
    }
    var _S912 : f32 = min(highest_0, 1.0f);
    return area_0 * _S912 * _S912 / (2.0f * (_S912 - max(lowest_0, -1.0f)) * squared_2);
}

fn is_sampled_well_0( position_1 : vec3<f32>) -> bool
{
    var _S913 : bool;
    if((word_0(u32(6))) != u32(1))
    {
        _S913 = true;
    }
    else
    {
        _S913 = (word_0(u32(2))) == u32(0);
    }
    if(_S913)
    {
        return false;
    }
    var record_5 : u32 = emitter_record_0(u32(0));
    if(is_area_0(record_5))
    {
        _S913 = (node_seen_0(word_0(record_5 + u32(5)), position_1)) < 1.0f;
    }
    else
    {
        _S913 = false;
    }
    return _S913;
}

fn has_smooth_0( lobe_7 : Lobe_0) -> bool
{
    return (lobe_7.kind_0) != u32(1);
}

fn largest_cosine_0( position_2 : vec3<f32>,  normal_0 : vec3<f32>,  centre_0 : vec3<f32>,  radius_1 : f32) -> f32
{
    var offset_1 : vec3<f32> = centre_0 - position_2;
    var distance_1 : f32 = length(offset_1);
    if(distance_1 <= radius_1)
    {
        return 1.0f;
    }
    var cosine_2 : f32 = dot(offset_1, normal_0) / distance_1;
    var sine_ball_0 : f32 = radius_1 / distance_1;
    var cosine_ball_0 : f32 = sqrt(max(1.0f - sine_ball_0 * sine_ball_0, 0.0f));
    if(cosine_2 >= cosine_ball_0)
    {
        return 1.0f;
    }
    return max(cosine_2 * cosine_ball_0 + sqrt(max(1.0f - cosine_2 * cosine_2, 0.0f)) * sine_ball_0 + 9.99999997475242708e-07f, 0.0f);
}

fn emitter_view_0( emitter_1 : u32,  position_3 : vec3<f32>,  normal_1 : vec3<f32>) -> f32
{
    var record_6 : u32 = emitter_record_0(emitter_1);
    if(!is_area_0(record_6))
    {
        return 3.14159274101257324f;
    }
    return node_seen_0(word_0(record_6 + u32(5)), position_3) * largest_cosine_0(position_3, normal_1, vector_at_0(record_6 + u32(8)), number_0(record_6 + u32(11)));
}

struct Choice_0
{
     position_4 : vec3<f32>,
     normal_2 : vec3<f32>,
     all_0 : f32,
     lit_0 : f32,
};

fn light_of_0( emitter_2 : u32,  choice_0 : Choice_0,  can_light_0 : ptr<function, f32>) -> f32
{
    var view_0 : f32 = emitter_view_0(emitter_2, choice_0.position_4, choice_0.normal_2);
    var _S914 : f32;
    if(view_0 > 0.0f)
    {
        _S914 = 1.0f;
    }
    else
    {
        _S914 = 0.0f;
    }
    (*can_light_0) = _S914;
    return view_0 * number_0(emitter_record_0(emitter_2) + u32(2));
}

fn light_of_1( emitter_3 : u32,  choice_1 : Choice_0,  can_light_1 : ptr<function, f32>) -> f32
{
    var view_1 : f32 = emitter_view_0(emitter_3, choice_1.position_4, choice_1.normal_2);
    var _S915 : f32;
    if(view_1 > 0.0f)
    {
        _S915 = 1.0f;
    }
    else
    {
        _S915 = 0.0f;
    }
    (*can_light_1) = _S915;
    return view_1 * number_0(emitter_record_0(emitter_3) + u32(2));
}

fn choice_at_0( position_5 : vec3<f32>,  normal_3 : vec3<f32>,  alike_0 : bool) -> Choice_0
{
    var choice_2 : Choice_0;
    choice_2.position_4 = position_5;
    choice_2.normal_2 = normal_3;
    choice_2.all_0 = 0.0f;
    choice_2.lit_0 = 0.0f;
    var count_1 : u32 = word_0(u32(6));
    var _S916 : bool;
    if(alike_0)
    {
        _S916 = true;
    }
    else
    {
        _S916 = (word_0(u32(5))) != u32(0);
    }
    if(_S916)
    {
        _S916 = true;
    }
    else
    {
        _S916 = count_1 < u32(2);
    }
    if(_S916)
    {
        _S916 = true;
    }
    else
    {
        _S916 = count_1 > u32(32);
    }
    if(_S916)
    {
        return choice_2;
    }
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < count_1)
        {
        }
        else
        {
            break;
        }
        var can_light_2 : f32;
        var _S917 : f32 = light_of_1(i_1, choice_2, &(can_light_2));
        choice_2.all_0 = choice_2.all_0 + _S917;
        choice_2.lit_0 = choice_2.lit_0 + can_light_2;
        i_1 = i_1 + u32(1);
    }
    if((choice_2.all_0) > 0.0f)
    {
        _S916 = (choice_2.all_0) < 3.00000000549775576e+38f;
    }
    else
    {
        _S916 = false;
    }
    if(!_S916)
    {
        choice_2.all_0 = 0.0f;
    }
    return choice_2;
}

fn product_2( a_8 : u32,  b_6 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_8 & (u32(65535)));
    var a1_0 : u32 = (a_8 >> (u32(16)));
    var b0_0 : u32 = (b_6 & (u32(65535)));
    var b1_0 : u32 = (b_6 >> (u32(16)));
    var low_0 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_0 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_0 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_9 : vec2<u32>,  b_7 : vec2<u32>) -> vec2<u32>
{
    var _S918 : u32 = a_9.x;
    var _S919 : u32 = b_7.x;
    var low_1 : vec2<u32> = product_2(_S918, _S919);
    return vec2<u32>(low_1.x, low_1.y + _S918 * b_7.y + a_9.y * _S919);
}

fn plus_0( a_10 : vec2<u32>,  b_8 : vec2<u32>) -> vec2<u32>
{
    var _S920 : u32 = a_10.x;
    var low_2 : u32 = _S920 + b_8.x;
    var _S921 : u32 = a_10.y + b_8.y;
    var _S922 : i32;
    if(low_2 < _S920)
    {
        _S922 = i32(1);
    }
    else
    {
        _S922 = i32(0);
    }
    return vec2<u32>(low_2, _S921 + u32(_S922));
}

fn shifted_xor_0( x_13 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S923 : u32 = x_13.y;
    return (x_13 ^ (vec2<u32>(((((x_13.x) >> (by_0))) | (((_S923 << ((u32(32) - by_0)))))), (_S923 >> (by_0)))));
}

fn mix_0( x_14 : vec2<u32>) -> vec2<u32>
{
    return shifted_xor_0(times_0(shifted_xor_0(times_0(shifted_xor_0(x_14, u32(30)), vec2<u32>(u32(484763065), u32(3210233709))), u32(27)), vec2<u32>(u32(321982955), u32(2496678331))), u32(31));
}

fn random_bits_0( key_1 : vec2<u32>,  dimension_0 : u32) -> vec2<u32>
{
    return mix_0(plus_0(key_1, times_0(vec2<u32>(dimension_0 + u32(1), u32(0)), vec2<u32>(u32(2135587861), u32(2654435769)))));
}

fn random_0( key_2 : vec2<u32>,  dimension_1 : u32) -> f32
{
    return f32(((random_bits_0(key_2, dimension_1).y) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn chance_of_0( emitter_4 : u32,  choice_3 : Choice_0) -> f32
{
    if((choice_3.all_0) == 0.0f)
    {
        return 1.0f / f32(word_0(u32(6)));
    }
    var can_light_3 : f32;
    var light_0 : f32 = light_of_0(emitter_4, choice_3, &(can_light_3));
    return 0.5f * can_light_3 / choice_3.lit_0 + 0.5f * light_0 / choice_3.all_0;
}

fn chosen_emitter_0( choice_4 : Choice_0,  u_0 : f32,  probability_2 : ptr<function, f32>) -> u32
{
    var count_2 : u32 = word_0(u32(6));
    (*probability_2) = 0.0f;
    if(count_2 == u32(0))
    {
        return u32(0);
    }
    if((choice_4.all_0) == 0.0f)
    {
        var _S924 : f32 = f32(count_2);
        (*probability_2) = 1.0f / _S924;
        return min(u32(u_0 * _S924), count_2 - u32(1));
    }
    var found_0 : u32 = u32(0);
    var i_2 : u32 = u32(0);
    var rest_1 : f32 = u_0;
    for(;;)
    {
        if(i_2 < count_2)
        {
        }
        else
        {
            break;
        }
        var own_0 : f32 = chance_of_0(i_2, choice_4);
        var found_1 : u32;
        if(own_0 > 0.0f)
        {
            (*probability_2) = own_0;
            found_1 = i_2;
        }
        else
        {
            found_1 = found_0;
        }
        if(rest_1 < own_0)
        {
            found_0 = found_1;
            break;
        }
        var rest_2 : f32 = rest_1 - own_0;
        var _S925 : u32 = i_2 + u32(1);
        found_0 = found_1;
        i_2 = _S925;
        rest_1 = rest_2;
    }
    return found_0;
}

fn limit_at_0( which_5 : u32) -> f32
{
    return primitives_0[word_0(u32(13)) + which_5];
}

fn angle_of_0( x_15 : f32,  y_4 : f32) -> f32
{
    var _S926 : f32 = abs(x_15);
    var _S927 : f32 = abs(y_4);
    var _S928 : f32 = min(_S926, _S927);
    var _S929 : f32 = max(_S926, _S927);
    var is_steep_0 : bool = _S928 > (0.41421356797218323f * _S929);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S928 - _S929;
    }
    else
    {
        above_0 = _S928;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S928 + _S929;
    }
    else
    {
        below_0 = _S929;
    }
    if(below_0 > 0.0f)
    {
    }
    else
    {
        below_0 = 1.0f;
    }
    var t_1 : f32 = above_0 / below_0;
    var z_0 : f32 = t_1 * t_1;
    var angle_0 : f32 = (((0.08053744584321976f * z_0 - 0.13877685368061066f) * z_0 + 0.19977711141109467f) * z_0 - 0.33332949876785278f) * z_0 * t_1 + t_1;
    var angle_1 : f32;
    if(is_steep_0)
    {
        angle_1 = angle_0 + 0.78539818525314331f;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(_S927 > _S926)
    {
        angle_1 = 1.57079637050628662f - angle_1;
    }
    if(x_15 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_4 < 0.0f)
    {
        above_0 = - angle_1;
    }
    else
    {
        above_0 = angle_1;
    }
    return above_0;
}

fn solid_angle_of_0( a_11 : vec3<f32>,  b_9 : vec3<f32>,  c_3 : vec3<f32>) -> f32
{
    var la_0 : f32 = length(a_11);
    var lb_0 : f32 = length(b_9);
    var lc_0 : f32 = length(c_3);
    var normal_4 : vec3<f32> = cross(b_9 - a_11, c_3 - a_11);
    var volume_0 : f32 = - dot(a_11, normal_4);
    if(!(volume_0 > (9.99999997475242708e-07f * max(max(la_0, lb_0), lc_0) * length(normal_4))))
    {
        return 0.0f;
    }
    return 2.0f * angle_of_0(la_0 * lb_0 * lc_0 + dot(a_11, b_9) * lc_0 + dot(b_9, c_3) * la_0 + dot(c_3, a_11) * lb_0, volume_0);
}

fn complex_product_0( a_12 : vec2<f32>,  b_10 : vec2<f32>) -> vec2<f32>
{
    var _S930 : f32 = a_12.x;
    var _S931 : f32 = b_10.x;
    var _S932 : f32 = a_12.y;
    var _S933 : f32 = b_10.y;
    return vec2<f32>(_S930 * _S931 - _S932 * _S933, _S930 * _S933 + _S932 * _S931);
}

struct SeenRectangle_0
{
     x_16 : vec2<f32>,
     y_5 : vec2<f32>,
     z_1 : f32,
     solid_angle_0 : f32,
     start_0 : vec2<f32>,
     inverse_to_line_0 : vec2<f32>,
};

fn seen_rectangle_0( at_10 : u32,  viewpoint_1 : vec3<f32>) -> SeenRectangle_0
{
    var offset_2 : vec3<f32> = vector_at_0(at_10) - viewpoint_1;
    var x0_0 : f32 = dot(vector_at_0(at_10 + u32(3)), offset_2);
    var y0_0 : f32 = dot(vector_at_0(at_10 + u32(6)), offset_2);
    var x1_0 : f32 = x0_0 + number_0(at_10 + u32(12));
    var y1_0 : f32 = y0_0 + number_0(at_10 + u32(13));
    var seen_1 : SeenRectangle_0;
    seen_1.x_16 = vec2<f32>(x0_0, x1_0);
    seen_1.y_5 = vec2<f32>(y0_0, y1_0);
    var _S934 : f32 = - dot(vector_at_0(at_10 + u32(9)), offset_2);
    seen_1.z_1 = _S934;
    var a_13 : vec3<f32> = vec3<f32>(x0_0, y0_0, _S934);
    var b_11 : vec3<f32> = vec3<f32>(x1_0, y0_0, _S934);
    var c_4 : vec3<f32> = vec3<f32>(x0_0, y1_0, _S934);
    var d_0 : vec3<f32> = vec3<f32>(x1_0, y1_0, _S934);
    var _S935 : f32 = length(a_13);
    var _S936 : f32 = length(c_4);
    var _S937 : f32;
    if(_S934 > (9.99999997475242708e-07f * max(max(_S935, length(b_11)), max(_S936, length(d_0)))))
    {
        _S937 = solid_angle_of_0(a_13, c_4, b_11) + solid_angle_of_0(d_0, b_11, c_4);
    }
    else
    {
        _S937 = 0.0f;
    }
    seen_1.solid_angle_0 = _S937;
    var z2_2 : f32 = seen_1.z_1 * seen_1.z_1;
    var at_first_0 : vec2<f32> = complex_product_0(vec2<f32>(x0_0 * y1_0, seen_1.z_1 * _S936), vec2<f32>(- x0_0 * y0_0, seen_1.z_1 * _S935));
    var to_line_0 : vec2<f32> = sqrt(seen_1.y_5 * seen_1.y_5 + vec2<f32>(z2_2));
    seen_1.start_0 = vec2<f32>(at_first_0.x, - at_first_0.y) * vec2<f32>((1.0f / ((x0_0 * x0_0 + z2_2) * to_line_0.x * to_line_0.y)));
    seen_1.inverse_to_line_0 = vec2<f32>(1.0f) / to_line_0;
    return seen_1;
}

fn sine_cosine_0( angle_2 : f32) -> vec2<f32>
{
    var quarters_0 : f32 = floor(angle_2 * 0.63661974668502808f + 0.5f);
    var x_17 : f32 = angle_2 - quarters_0 * 1.5703125f - quarters_0 * 0.00048375129699707f - quarters_0 * 7.54979012640433211e-08f;
    var z_2 : f32 = x_17 * x_17;
    var sine_1 : f32 = ((-0.00019515295571182f * z_2 + 0.00833216123282909f) * z_2 - 0.16666655242443085f) * z_2 * x_17 + x_17;
    var cosine_3 : f32 = ((0.00002443315679557f * z_2 - 0.00138873164542019f) * z_2 + 0.04166664555668831f) * z_2 * z_2 - 0.5f * z_2 + 1.0f;
    var quarter_0 : i32 = (i32(quarters_0) & (i32(3)));
    var turned_0 : vec2<f32>;
    if(((quarter_0 & (i32(1)))) != i32(0))
    {
        turned_0 = vec2<f32>(cosine_3, - sine_1);
    }
    else
    {
        turned_0 = vec2<f32>(sine_1, cosine_3);
    }
    if(quarter_0 < i32(2))
    {
    }
    else
    {
        turned_0 = (vec2<f32>(0) - turned_0);
    }
    return turned_0;
}

fn rectangle_place_0( seen_2 : SeenRectangle_0,  u_1 : vec2<f32>) -> vec2<f32>
{
    var turn_0 : vec2<f32> = sine_cosine_0(u_1.x * seen_2.solid_angle_0);
    var at_11 : vec2<f32> = complex_product_0(seen_2.start_0, vec2<f32>(turn_0.y, turn_0.x));
    var _S938 : f32 = seen_2.y_5.x;
    var _S939 : f32 = seen_2.inverse_to_line_0.x;
    var _S940 : f32 = seen_2.y_5.y;
    var n_3 : f32 = - at_11.x * _S938 * _S939 - _S940 * seen_2.inverse_to_line_0.y;
    var _S941 : f32 = at_11.y;
    var flat_0 : f32 = _S941 * seen_2.z_1 * _S939;
    var size_0 : f32 = seen_2.z_1 * abs(_S941) / sqrt(max(n_3 * n_3 - flat_0 * flat_0, 0.0f));
    var _S942 : f32;
    if((n_3 * _S941) < 0.0f)
    {
        _S942 = - size_0;
    }
    else
    {
        _S942 = size_0;
    }
    var x_18 : f32 = clamp(_S942, seen_2.x_16.x, seen_2.x_16.y);
    var squared_3 : f32 = x_18 * x_18 + seen_2.z_1 * seen_2.z_1;
    var h_0 : vec2<f32> = seen_2.y_5 / sqrt(vec2<f32>(squared_3) + seen_2.y_5 * seen_2.y_5);
    var _S943 : f32 = h_0.x;
    var sine_2 : f32 = _S943 + u_1.y * (h_0.y - _S943);
    return vec2<f32>(x_18, clamp(sine_2 * sqrt(squared_3 / max((1.0f - sine_2) * (1.0f + sine_2), 0.0f)), _S938, _S940));
}

fn rectangle_face_0( at_12 : u32,  place_11 : vec2<f32>,  weights_3 : ptr<function, vec2<f32>>) -> u32
{
    var best_0 : f32 = -1.00000001504746622e+30f;
    var found_2 : u32 = u32(0);
    var face_0 : u32 = u32(0);
    for(;;)
    {
        if(face_0 < u32(2))
        {
        }
        else
        {
            break;
        }
        var row_1 : u32 = at_12 + u32(14) + u32(6) * face_0;
        var _S944 : f32 = place_11.x;
        var _S945 : f32 = place_11.y;
        var v_4 : f32 = number_0(row_1) + number_0(row_1 + u32(1)) * _S944 + number_0(row_1 + u32(2)) * _S945;
        var w_2 : f32 = number_0(row_1 + u32(3)) + number_0(row_1 + u32(4)) * _S944 + number_0(row_1 + u32(5)) * _S945;
        var _S946 : f32 = min(min(v_4, w_2), 1.0f - v_4 - w_2);
        if(_S946 > best_0)
        {
            (*weights_3)[i32(0)] = clamp(v_4, 0.0f, 1.0f);
            (*weights_3)[i32(1)] = clamp(w_2, 0.0f, 1.0f - (*weights_3).x);
            best_0 = _S946;
            found_2 = face_0;
        }
        face_0 = face_0 + u32(1);
    }
    return found_2;
}

fn emitter_triangle_0( record_7 : u32,  face_1 : u32) -> u32
{
    return word_0(word_0(u32(12)) + word_0(record_7 + u32(3)) + face_1);
}

fn precise_random_0( key_3 : vec2<u32>,  dimension_2 : u32) -> f32
{
    return f32(((random_bits_0(key_3, dimension_2).y) >> (u32(8)))) / 4096.0f / 4096.0f;
}

fn shares_of_0( nodes_at_0 : u32,  node_1 : u32,  viewpoint_2 : vec3<f32>) -> vec2<f32>
{
    var _S947 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(2)), viewpoint_2);
    var _S948 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(3)), viewpoint_2);
    var seen_3 : vec2<f32> = vec2<f32>(_S947, _S948);
    var sum_3 : f32 = _S947 + _S948;
    var _S949 : vec2<f32>;
    if(sum_3 > 0.0f)
    {
        _S949 = seen_3 / vec2<f32>(sum_3);
    }
    else
    {
        _S949 = vec2<f32>(0.0f);
    }
    return _S949;
}

struct Corners_0
{
     a_14 : vec3<f32>,
     b_12 : vec3<f32>,
     c_5 : vec3<f32>,
};

fn corners_from_0( record_8 : u32,  face_2 : u32,  viewpoint_3 : vec3<f32>) -> Corners_0
{
    var at_13 : u32 = u32(9) * emitter_triangle_0(record_8, face_2);
    var corners_0 : Corners_0;
    corners_0.a_14 = primitive_vector_0(at_13) - viewpoint_3;
    corners_0.b_12 = primitive_vector_0(at_13 + u32(3)) - viewpoint_3;
    corners_0.c_5 = primitive_vector_0(at_13 + u32(6)) - viewpoint_3;
    return corners_0;
}

fn face_solid_angle_0( record_9 : u32,  face_3 : u32,  viewpoint_4 : vec3<f32>) -> f32
{
    var corners_1 : Corners_0 = corners_from_0(record_9, face_3, viewpoint_4);
    return solid_angle_of_0(corners_1.a_14, corners_1.b_12, corners_1.c_5);
}

fn unit_across_0( v_5 : vec3<f32>,  axis_1 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_5 - axis_1 * vec3<f32>(dot(v_5, axis_1)));
}

fn along_0( from_0 : vec3<f32>,  to_0 : vec3<f32>,  cosine_4 : f32) -> vec3<f32>
{
    var _S950 : f32 = clamp(cosine_4, -1.0f, 1.0f);
    return from_0 * vec3<f32>(_S950) + unit_across_0(to_0, from_0) * vec3<f32>(sqrt((1.0f - _S950) * (1.0f + _S950)));
}

fn triangle_direction_0( a_15 : vec3<f32>,  b_13 : vec3<f32>,  c_6 : vec3<f32>,  area_1 : f32,  u_2 : vec2<f32>) -> vec3<f32>
{
    var _S951 : vec3<f32> = normalize(a_15);
    var _S952 : vec3<f32> = normalize(b_13);
    var _S953 : vec3<f32> = normalize(c_6);
    var ab_0 : vec3<f32> = normalize(cross(_S951, _S952));
    var ca_0 : vec3<f32> = normalize(cross(_S953, _S951));
    var sine_alpha_0 : f32 = length(cross(ab_0, ca_0));
    var cosine_alpha_0 : f32 = - dot(ab_0, ca_0);
    var part_0 : vec2<f32> = sine_cosine_0(u_2.x * area_1);
    var _S954 : f32 = part_0.x;
    var _S955 : f32 = part_0.y;
    var sine_phi_0 : f32 = _S954 * cosine_alpha_0 - _S955 * sine_alpha_0;
    var cosine_phi_0 : f32 = _S955 * cosine_alpha_0 + _S954 * sine_alpha_0;
    var k1_0 : f32 = cosine_phi_0 - cosine_alpha_0;
    var k2_0 : f32 = sine_phi_0 + sine_alpha_0 * dot(_S951, _S952);
    var between_1 : vec3<f32> = along_0(_S951, _S953, ((k2_0 * cosine_phi_0 - k1_0 * sine_phi_0) * cosine_alpha_0 - k2_0) / ((k2_0 * sine_phi_0 + k1_0 * cosine_phi_0) * sine_alpha_0));
    return along_0(_S952, between_1, 1.0f - u_2.y * (1.0f - dot(between_1, _S952)));
}

fn density_of_0( solid_angle_1 : f32,  normal_5 : vec3<f32>,  distance_2 : f32,  direction_4 : vec3<f32>) -> f32
{
    if(!(solid_angle_1 < 0.00100000004749745f))
    {
        return 1.0f;
    }
    return solid_angle_1 * 2.0f * distance_2 * distance_2 / abs(dot(normal_5, direction_4));
}

struct EmitterPoint_0
{
     place_12 : Place_0,
     pdf_2 : f32,
};

fn area_point_0( record_10 : u32,  from_1 : Surface_0,  key_4 : vec2<u32>,  dimension_3 : u32) -> EmitterPoint_0
{
    var total_0 : f32;
    var point_0 : EmitterPoint_0;
    point_0.pdf_2 = 0.0f;
    point_0.place_12 = place_at_0(u32(0), 0.0f, 0.0f);
    var second_1 : f32 = random_0(key_4, dimension_3 + u32(1));
    var rectangle_0 : u32 = word_0(record_10 + u32(4));
    if(rectangle_0 != u32(4294967295))
    {
        var seen_4 : SeenRectangle_0 = seen_rectangle_0(rectangle_0, from_1.position_0);
        if(!((seen_4.solid_angle_0) > 0.0f))
        {
            return point_0;
        }
        if((seen_4.solid_angle_0) >= 0.00100000004749745f)
        {
            var weights_4 : vec2<f32>;
            var face_4 : u32 = rectangle_face_0(rectangle_0, rectangle_place_0(seen_4, vec2<f32>(random_0(key_4, dimension_3), second_1)) - vec2<f32>(seen_4.x_16.x, seen_4.y_5.x), &(weights_4));
            point_0.place_12.triangle_0 = emitter_triangle_0(record_10, face_4);
            point_0.place_12.v_0 = weights_4.x;
            point_0.place_12.w_0 = weights_4.y;
            point_0.pdf_2 = 1.0f / seen_4.solid_angle_0;
            return point_0;
        }
    }
    var _S956 : f32 = precise_random_0(key_4, dimension_3);
    var nodes_at_1 : u32 = word_0(record_10 + u32(5));
    var node_2 : u32 = nodes_at_1;
    var u_3 : f32 = _S956;
    var chosen_0 : f32 = 1.0f;
    for(;;)
    {
        if((word_0(node_2 + u32(2))) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var shares_0 : vec2<f32> = shares_of_0(nodes_at_1, node_2, from_1.position_0);
        var _S957 : f32 = shares_0.x;
        var _S958 : f32 = shares_0.y;
        if(!((_S957 + _S958) > 0.0f))
        {
            return point_0;
        }
        var is_second_0 : bool;
        if(u_3 >= _S957)
        {
            is_second_0 = _S958 > 0.0f;
        }
        else
        {
            is_second_0 = false;
        }
        if(is_second_0)
        {
            u_3 = (u_3 - _S957) / _S958;
        }
        else
        {
            u_3 = min(u_3 / _S957, 1.0f);
        }
        if(is_second_0)
        {
            total_0 = _S958;
        }
        else
        {
            total_0 = _S957;
        }
        var chosen_1 : f32 = chosen_0 * total_0;
        var _S959 : i32;
        if(is_second_0)
        {
            _S959 = i32(3);
        }
        else
        {
            _S959 = i32(2);
        }
        node_2 = nodes_at_1 + u32(17) * word_0(node_2 + u32(_S959));
        chosen_0 = chosen_1;
    }
    var first_2 : u32 = word_0(node_2);
    var _S960 : u32 = word_0(node_2 + u32(1));
    var _S961 : u32 = word_0(record_10 + u32(6));
    var k_2 : u32 = first_2;
    total_0 = 0.0f;
    for(;;)
    {
        if(k_2 < _S960)
        {
        }
        else
        {
            break;
        }
        var total_1 : f32 = total_0 + face_solid_angle_0(record_10, word_0(_S961 + k_2), from_1.exact_0);
        k_2 = k_2 + u32(1);
        total_0 = total_1;
    }
    var _S962 : f32 = u_3 * total_0;
    var face_5 : u32 = u32(4294967295);
    var angle_3 : f32 = 0.0f;
    var inside_2 : f32 = 0.0f;
    k_2 = first_2;
    var rest_3 : f32 = _S962;
    for(;;)
    {
        if(k_2 < _S960)
        {
        }
        else
        {
            break;
        }
        var _S963 : u32 = _S961 + k_2;
        var own_1 : f32 = face_solid_angle_0(record_10, word_0(_S963), from_1.exact_0);
        if(!(own_1 > 0.0f))
        {
            k_2 = k_2 + u32(1);
            continue;
        }
        var _S964 : u32 = word_0(_S963);
        var _S965 : f32 = min(rest_3 / own_1, 1.0f);
        if(rest_3 < own_1)
        {
            face_5 = _S964;
            angle_3 = own_1;
            inside_2 = _S965;
            break;
        }
        var rest_4 : f32 = rest_3 - own_1;
        face_5 = _S964;
        angle_3 = own_1;
        inside_2 = _S965;
        rest_3 = rest_4;
        k_2 = k_2 + u32(1);
    }
    if(face_5 == u32(4294967295))
    {
        return point_0;
    }
    var corners_2 : Corners_0 = corners_from_0(record_10, face_5, from_1.exact_0);
    var ab_1 : vec3<f32> = corners_2.b_12 - corners_2.a_14;
    var ac_0 : vec3<f32> = corners_2.c_5 - corners_2.a_14;
    var normal_6 : vec3<f32> = cross(ab_1, ac_0);
    point_0.place_12.triangle_0 = emitter_triangle_0(record_10, face_5);
    if(angle_3 < 0.00100000004749745f)
    {
        var root_0 : f32 = sqrt(inside_2);
        point_0.place_12.v_0 = root_0 * (1.0f - second_1);
        point_0.place_12.w_0 = root_0 * second_1;
    }
    else
    {
        var direction_5 : vec3<f32> = triangle_direction_0(corners_2.a_14, corners_2.b_12, corners_2.c_5, angle_3, vec2<f32>(inside_2, second_1));
        var within_0 : vec3<f32> = direction_5 * vec3<f32>((dot(corners_2.a_14, normal_6) / dot(direction_5, normal_6))) - corners_2.a_14;
        var squared_4 : f32 = dot(normal_6, normal_6);
        var _S966 : f32 = clamp(dot(cross(within_0, ac_0), normal_6) / squared_4, 0.0f, 1.0f);
        point_0.place_12.v_0 = _S966;
        point_0.place_12.w_0 = clamp(dot(cross(ab_1, within_0), normal_6) / squared_4, 0.0f, 1.0f - _S966);
    }
    var offset_3 : vec3<f32> = corners_2.a_14 + ab_1 * vec3<f32>(point_0.place_12.v_0) + ac_0 * vec3<f32>(point_0.place_12.w_0);
    var distance_3 : f32 = length(offset_3);
    if(!(distance_3 > 0.0f))
    {
        return point_0;
    }
    point_0.pdf_2 = chosen_0 / total_0 * density_of_0(angle_3, normal_6, distance_3, offset_3 / vec3<f32>(distance_3));
    return point_0;
}

fn is_map_0( record_11 : u32) -> bool
{
    return (word_0(record_11)) == u32(2);
}

fn uniform_direction_0( u_4 : vec2<f32>) -> vec3<f32>
{
    var _S967 : f32 = u_4.x;
    var turn_1 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_4.y) * vec2<f32>((2.0f * sqrt(_S967 * (1.0f - _S967))));
    return vec3<f32>(turn_1.y, turn_1.x, 1.0f - 2.0f * _S967);
}

fn map_place_0( map_0 : u32,  direction_6 : vec3<f32>) -> vec2<f32>
{
    var _S968 : u32 = map_0 + u32(2);
    var d_1 : vec3<f32> = vector_at_0(_S968) * vec3<f32>(direction_6.x) + vector_at_0(_S968 + u32(3)) * vec3<f32>(direction_6.y) + vector_at_0(_S968 + u32(6)) * vec3<f32>(direction_6.z);
    return vec2<f32>(angle_of_0(- d_1.z, d_1.x) * 0.15915493667125702f * f32(word_0(map_0)) - 0.5f, angle_of_0(d_1.y, length(d_1.xz)) * 0.31830987334251404f * (f32(word_0(map_0 + u32(1))) - 1.0f));
}

fn cell_pdf_0( map_1 : u32,  cell_0 : u32) -> f32
{
    return 0.00397887360304594f + 0.94999998807907104f * number_0(word_0(map_1 + u32(15)) + cell_0);
}

fn map_pdf_0( map_2 : u32,  direction_7 : vec3<f32>) -> f32
{
    if((word_0(map_2 + u32(13))) == u32(4294967295))
    {
        return 0.07957746833562851f;
    }
    var place_13 : vec2<f32> = map_place_0(map_2, direction_7);
    var width_1 : u32 = word_0(map_2);
    var column_0 : u32 = wrapped_0(floor_of_0(place_13.x), i32(width_1), u32(0));
    return cell_pdf_0(map_2, u32(clamp(floor_of_0(place_13.y), i32(0), i32(word_0(map_2 + u32(1))) - i32(2))) * width_1 + column_0);
}

fn sum_at_0( at_14 : u32) -> f32
{
    return number_0(at_14) + number_0(at_14 + u32(1));
}

fn chosen_interval_0( sums_1 : u32,  count_3 : u32,  u_5 : f32,  through_0 : ptr<function, f32>) -> u32
{
    var _S969 : u32 = count_3 - u32(1);
    var total_2 : f32 = sum_at_0(sums_1 + u32(2) * _S969);
    var target_0 : f32 = u_5 * total_2;
    var low_3 : u32 = u32(0);
    var high_0 : u32 = _S969;
    for(;;)
    {
        if(low_3 < high_0)
        {
        }
        else
        {
            break;
        }
        var middle_1 : u32 = (low_3 + high_0) / u32(2);
        var sum_4 : f32 = sum_at_0(sums_1 + u32(2) * middle_1);
        var _S970 : bool;
        if(sum_4 <= target_0)
        {
            _S970 = sum_4 < total_2;
        }
        else
        {
            _S970 = false;
        }
        if(_S970)
        {
            low_3 = middle_1 + u32(1);
        }
        else
        {
            high_0 = middle_1;
        }
    }
    var below_1 : f32;
    if(low_3 > u32(0))
    {
        below_1 = sum_at_0(sums_1 + u32(2) * (low_3 - u32(1)));
    }
    else
    {
        below_1 = 0.0f;
    }
    (*through_0) = clamp((target_0 - below_1) / (sum_at_0(sums_1 + u32(2) * low_3) - below_1), 0.0f, 1.0f);
    return low_3;
}

fn cell_direction_0( map_3 : u32,  column_1 : u32,  row_2 : u32,  along_1 : f32,  down_0 : f32) -> vec3<f32>
{
    var turns_0 : f32 = (f32(column_1) + 0.5f + along_1) / f32(word_0(map_3));
    var azimuth_0 : vec2<f32> = sine_cosine_0(6.28318548202514648f * (turns_0 - floor(turns_0 + 0.5f)));
    var last_0 : u32 = word_0(map_3 + u32(1)) - u32(1);
    var is_lower_0 : bool = (u32(2) * row_2) >= last_0;
    var rows_1 : vec2<f32>;
    if(is_lower_0)
    {
        var _S971 : u32 = last_0 - row_2;
        rows_1 = vec2<f32>(f32(_S971), f32(_S971 - u32(1)));
    }
    else
    {
        rows_1 = vec2<f32>(f32(row_2), f32(row_2 + u32(1)));
    }
    var _S972 : f32 = f32(last_0);
    var _S973 : f32 = sine_cosine_0(rows_1.x * (1.57079637050628662f / _S972)).x;
    var _S974 : f32 = sine_cosine_0(rows_1.y * (1.57079637050628662f / _S972)).x;
    var off_0 : f32 = 2.0f * mix(_S973 * _S973, _S974 * _S974, down_0);
    var sine_3 : f32 = sqrt(off_0 * (2.0f - off_0));
    var _S975 : f32 = azimuth_0.x * sine_3;
    var _S976 : f32;
    if(is_lower_0)
    {
        _S976 = off_0 - 1.0f;
    }
    else
    {
        _S976 = 1.0f - off_0;
    }
    var local_0 : vec3<f32> = vec3<f32>(_S975, _S976, - azimuth_0.y * sine_3);
    var _S977 : u32 = map_3 + u32(2);
    return vec3<f32>(dot(vector_at_0(_S977), local_0), dot(vector_at_0(_S977 + u32(3)), local_0), dot(vector_at_0(_S977 + u32(6)), local_0));
}

fn sample_map_0( map_4 : u32,  key_5 : vec2<u32>,  dimension_4 : u32,  pdf_3 : ptr<function, f32>) -> vec3<f32>
{
    var u_6 : f32 = precise_random_0(key_5, dimension_4);
    var rest_5 : f32 = u_6 * 20.0f - 1.0f;
    var _S978 : u32 = map_4 + u32(13);
    var is_black_0 : bool = (word_0(_S978)) == u32(4294967295);
    var _S979 : bool;
    if(is_black_0)
    {
        _S979 = true;
    }
    else
    {
        _S979 = rest_5 < 0.0f;
    }
    if(_S979)
    {
        var share_0 : f32;
        if(is_black_0)
        {
            share_0 = 1.0f;
        }
        else
        {
            share_0 = 0.05000000074505806f;
        }
        var direction_8 : vec3<f32> = uniform_direction_0(vec2<f32>(u_6 / share_0, random_0(key_5, dimension_4 + u32(1))));
        var _S980 : f32 = map_pdf_0(map_4, direction_8);
        (*pdf_3) = _S980;
        return direction_8;
    }
    var rest_6 : f32 = rest_5 / 19.0f;
    var width_2 : u32 = word_0(map_4);
    var down_1 : f32;
    var row_3 : u32 = chosen_interval_0(word_0(_S978), word_0(map_4 + u32(1)) - u32(1), precise_random_0(key_5, dimension_4 + u32(1)), &(down_1));
    var along_2 : f32;
    var column_2 : u32 = chosen_interval_0(word_0(map_4 + u32(14)) + u32(2) * width_2 * row_3, width_2, rest_6, &(along_2));
    (*pdf_3) = cell_pdf_0(map_4, row_3 * width_2 + column_2);
    return cell_direction_0(map_4, column_2, row_3, along_2, down_1);
}

fn random_pair_0( key_6 : vec2<u32>,  dimension_5 : u32) -> vec2<f32>
{
    return vec2<f32>(random_0(key_6, dimension_5), random_0(key_6, dimension_5 + u32(1)));
}

fn sample_cosine_0( u_7 : vec2<f32>) -> vec3<f32>
{
    var _S981 : f32 = u_7.x;
    var turn_2 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_7.y) * vec2<f32>(sqrt(_S981));
    return vec3<f32>(turn_2.y, turn_2.x, sqrt(1.0f - _S981));
}

fn to_world_0( axes_4 : Axes_0,  v_6 : vec3<f32>) -> vec3<f32>
{
    return axes_4.s_0 * vec3<f32>(v_6.x) + axes_4.t_0 * vec3<f32>(v_6.y) + axes_4.n_1 * vec3<f32>(v_6.z);
}

fn component_0( v_7 : vec3<f32>,  axis_2 : u32) -> f32
{
    var _S982 : f32;
    if(axis_2 == u32(0))
    {
        _S982 = v_7.x;
    }
    else
    {
        if(axis_2 == u32(1))
        {
            _S982 = v_7.y;
        }
        else
        {
            _S982 = v_7.z;
        }
    }
    return _S982;
}

fn ray_child_0( node_3 : u32,  slot_2 : u32) -> u32
{
    return nodes_0[u32(14) * node_3 + u32(12) + slot_2 / u32(4)][slot_2 % u32(4)];
}

struct RayView_0
{
     inverse_2 : vec3<f32>,
     offset_near_0 : vec3<f32>,
     offset_far_0 : vec3<f32>,
     limit_0 : f32,
     margin_0 : f32,
     axes_5 : u32,
};

fn ray_bound_0( view_2 : RayView_0,  limit_1 : f32,  node_4 : u32,  slot_3 : u32) -> f32
{
    var _S983 : u32 = u32(14) * node_4 + slot_3 / u32(4);
    var near_0 : f32 = 0.0f;
    var far_0 : f32 = limit_1;
    var axis_3 : u32 = u32(0);
    for(;;)
    {
        if(axis_3 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S984 : u32 = axis_3;
        var _S985 : u32 = _S983 + u32(2) * axis_3;
        var _S986 : u32 = slot_3 % u32(4);
        var low_4 : f32 = (bitcast<f32>((nodes_0[_S985][_S986])));
        var high_1 : f32 = (bitcast<f32>((nodes_0[_S985 + u32(6)][_S986])));
        var _S987 : bool = (view_2.inverse_2[axis_3]) < 0.0f;
        var _S988 : f32;
        if(_S987)
        {
            _S988 = high_1;
        }
        else
        {
            _S988 = low_4;
        }
        var _S989 : f32 = max(near_0, _S988 * view_2.inverse_2[_S984] - view_2.offset_near_0[axis_3]);
        var _S990 : f32;
        if(_S987)
        {
            _S990 = low_4;
        }
        else
        {
            _S990 = high_1;
        }
        var _S991 : f32 = min(far_0, _S990 * view_2.inverse_2[_S984] - view_2.offset_far_0[axis_3]);
        var _S992 : u32 = axis_3 + u32(1);
        near_0 = _S989;
        far_0 = _S991;
        axis_3 = _S992;
    }
    if(near_0 <= far_0)
    {
    }
    else
    {
        near_0 = 3.00000000549775576e+38f;
    }
    return near_0;
}

fn nearest_first_0( bounds_0 : array<f32, i32(8)>,  limit_2 : f32) -> u32
{
    var k_3 : u32 = u32(0);
    var order_0 : u32 = u32(0);
    for(;;)
    {
        if(k_3 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S993 : u32 = k_3;
        if((bounds_0[k_3]) > limit_2)
        {
            k_3 = k_3 + u32(1);
            continue;
        }
        var j_0 : u32 = u32(0);
        var rank_0 : u32 = u32(0);
        for(;;)
        {
            if(j_0 < u32(8))
            {
            }
            else
            {
                break;
            }
            var _S994 : u32 = j_0;
            var _S995 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S993]))
            {
                _S995 = true;
            }
            else
            {
                if((bounds_0[_S994]) == (bounds_0[_S993]))
                {
                    _S995 = j_0 < k_3;
                }
                else
                {
                    _S995 = false;
                }
            }
            if(_S995)
            {
                rank_0 = rank_0 + u32(1);
            }
            j_0 = j_0 + u32(1);
        }
        order_0 = (order_0 | ((((k_3 + u32(1)) << ((u32(4) * rank_0))))));
        k_3 = k_3 + u32(1);
    }
    return order_0;
}

fn crossed_0( view_3 : RayView_0,  limit_3 : f32,  node_5 : u32) -> u32
{
    var bounds_1 : array<f32, i32(8)>;
    var slot_4 : u32 = u32(0);
    for(;;)
    {
        if(slot_4 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S996 : f32;
        if((ray_child_0(node_5, slot_4)) == u32(4294967295))
        {
            _S996 = 3.00000000549775576e+38f;
        }
        else
        {
            _S996 = ray_bound_0(view_3, limit_3, node_5, slot_4);
        }
        bounds_1[slot_4] = _S996;
        slot_4 = slot_4 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_3 : f32,  largest_0 : f32) -> f32
{
    return min(product_3, largest_0);
}

struct Ray_0
{
     origin_0 : vec3<f32>,
     shear_x_0 : f32,
     shear_y_0 : f32,
     inverse_z_0 : f32,
     t_min_0 : f32,
     t_max_0 : f32,
     local_per_t_0 : f32,
     enter_0 : f32,
     edge_on_0 : f32,
     largest_1 : f32,
};

fn corner_0( ray_0 : Ray_0,  axes_6 : u32,  at_15 : u32) -> vec3<f32>
{
    var relative_0 : vec3<f32> = primitive_vector_0(at_15) - ray_0.origin_0;
    var z_3 : f32 = component_0(relative_0, (axes_6 >> (u32(4))));
    return vec3<f32>(component_0(relative_0, (axes_6 & (u32(3)))) - rounded_0(ray_0.shear_x_0 * z_3, ray_0.largest_1), component_0(relative_0, (((axes_6 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_0.shear_y_0 * z_3, ray_0.largest_1), z_3);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_2 : f32,
     v_8 : f32,
     w_3 : f32,
};

fn intersect_0( ray_1 : Ray_0,  axes_7 : u32,  at_16 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_2 = 0.0f;
    crossing_0.v_8 = 0.0f;
    crossing_0.w_3 = 0.0f;
    var a_16 : vec3<f32> = corner_0(ray_1, axes_7, at_16);
    var b_14 : vec3<f32> = corner_0(ray_1, axes_7, at_16 + u32(3));
    var c_7 : vec3<f32> = corner_0(ray_1, axes_7, at_16 + u32(6));
    var _S997 : f32 = c_7.x;
    var _S998 : f32 = b_14.y;
    var cx_by_0 : f32 = rounded_0(_S997 * _S998, ray_1.largest_1);
    var _S999 : f32 = c_7.y;
    var _S1000 : f32 = b_14.x;
    var cy_bx_0 : f32 = rounded_0(_S999 * _S1000, ray_1.largest_1);
    var _S1001 : f32 = a_16.x;
    var ax_cy_0 : f32 = rounded_0(_S1001 * _S999, ray_1.largest_1);
    var _S1002 : f32 = a_16.y;
    var ay_cx_0 : f32 = rounded_0(_S1002 * _S997, ray_1.largest_1);
    var bx_ay_0 : f32 = rounded_0(_S1000 * _S1002, ray_1.largest_1);
    var by_ax_0 : f32 = rounded_0(_S998 * _S1001, ray_1.largest_1);
    var u_8 : f32 = cx_by_0 - cy_bx_0;
    var v_9 : f32 = ax_cy_0 - ay_cx_0;
    var w_4 : f32 = bx_ay_0 - by_ax_0;
    var _S1003 : f32 = min(min(u_8, v_9), w_4);
    var _S1004 : f32 = max(max(u_8, v_9), w_4);
    var _S1005 : bool;
    if(_S1003 < 0.0f)
    {
        _S1005 = _S1004 > 0.0f;
    }
    else
    {
        _S1005 = false;
    }
    if(_S1005)
    {
        return crossing_0;
    }
    var determinant_0 : f32 = u_8 + v_9 + w_4;
    if(_S1003 <= 0.0f)
    {
        _S1005 = _S1004 >= 0.0f;
    }
    else
    {
        _S1005 = false;
    }
    if(_S1005)
    {
        if((abs(determinant_0)) <= (ray_1.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0f)
    {
        return crossing_0;
    }
    var t_3 : f32 = (rounded_0(u_8 * a_16.z, ray_1.largest_1) + rounded_0(v_9 * b_14.z, ray_1.largest_1) + rounded_0(w_4 * c_7.z, ray_1.largest_1)) / determinant_0 * ray_1.inverse_z_0;
    if((ray_1.t_min_0) <= t_3)
    {
        _S1005 = t_3 <= (ray_1.t_max_0);
    }
    else
    {
        _S1005 = false;
    }
    crossing_0.is_hit_0 = _S1005;
    crossing_0.t_2 = t_3;
    crossing_0.v_8 = v_9 / determinant_0;
    crossing_0.w_3 = w_4 / determinant_0;
    return crossing_0;
}

fn face_6( triangle_6 : u32) -> u32
{
    return rough_0[triangle_6 / u32(4)][triangle_6 % u32(4)];
}

struct Found_0
{
     face_7 : u32,
     triangle_7 : u32,
     v_10 : f32,
     w_5 : f32,
};

fn first_found_0( view_4 : RayView_0,  ray_2 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S1006 : bool;
    var found_3 : Found_0;
    found_3.face_7 = u32(4294967295);
    found_3.triangle_7 = u32(4294967295);
    found_3.v_10 = 0.0f;
    found_3.w_5 = 0.0f;
    if(!((view_4.limit_0) >= 0.0f))
    {
        return found_3;
    }
    var way_1 : array<vec2<u32>, i32(40)>;
    way_1[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_4.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_1[level_0] = vec2<u32>(entered_0, crossed_0(view_4, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_1 : vec2<u32> = way_1[level_0];
        var _S1007 : u32 = way_1[level_0].y;
        if(_S1007 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S1008 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S1008;
            continue;
        }
        var slot_5 : u32 = ((_S1007 & (u32(15)))) - u32(1);
        way_1[level_0][i32(1)] = (_S1007 >> (u32(4)));
        var _S1009 : bool;
        if(!is_new_1)
        {
            _S1009 = (ray_bound_0(view_4, limit_4, here_1.x, slot_5)) > limit_4;
        }
        else
        {
            _S1009 = false;
        }
        if(_S1009)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_1.x, slot_5);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S1010 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S1010;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S1011 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S1012 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_3 : u32 = _S1012;
        for(;;)
        {
            if(i_3 < _S1011)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_2), view_4.axes_5, u32(9) * i_3);
            if(!crossing_1.is_hit_0)
            {
                i_3 = i_3 + u32(1);
                continue;
            }
            if((found_3.face_7) == u32(4294967295))
            {
                _S1006 = true;
            }
            else
            {
                _S1006 = (crossing_1.t_2) < ((*ray_2).t_max_0);
            }
            var _S1013 : bool;
            if(_S1006)
            {
                _S1013 = true;
            }
            else
            {
                _S1013 = (face_6(i_3)) < (found_3.face_7);
            }
            var limit_6 : f32;
            if(_S1013)
            {
                found_3.face_7 = face_6(i_3);
                found_3.triangle_7 = i_3;
                (*ray_2).t_max_0 = crossing_1.t_2;
                found_3.v_10 = crossing_1.v_8;
                found_3.w_5 = crossing_1.w_3;
                limit_6 = min(limit_5, crossing_1.t_2 * (*ray_2).local_per_t_0 - (*ray_2).enter_0 + 2.0f * view_4.margin_0);
            }
            else
            {
                limit_6 = limit_5;
            }
            limit_5 = limit_6;
            i_3 = i_3 + u32(1);
        }
        if(any_0)
        {
            _S1006 = (found_3.face_7) != u32(4294967295);
        }
        else
        {
            _S1006 = false;
        }
        if(_S1006)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_3;
}

fn cast_0( origin_1 : vec3<f32>,  direction_9 : vec3<f32>,  t_min_1 : f32,  t_max_1 : f32,  any_1 : bool,  t_4 : ptr<function, f32>) -> Found_0
{
    var size_1 : vec3<f32> = abs(direction_9);
    var _S1014 : f32 = size_1.x;
    var _S1015 : f32 = size_1.y;
    var _S1016 : bool;
    if(_S1014 >= _S1015)
    {
        _S1016 = _S1014 >= (size_1.z);
    }
    else
    {
        _S1016 = false;
    }
    var _S1017 : i32;
    if(_S1016)
    {
        _S1017 = i32(0);
    }
    else
    {
        if(_S1015 >= (size_1.z))
        {
            _S1017 = i32(1);
        }
        else
        {
            _S1017 = i32(2);
        }
    }
    var z_4 : u32 = u32(_S1017);
    var x_19 : u32 = (z_4 + u32(1)) % u32(3);
    var y_6 : u32 = (z_4 + u32(2)) % u32(3);
    var ray_3 : Ray_0;
    ray_3.origin_0 = origin_1;
    var along_3 : f32 = component_0(direction_9, z_4);
    ray_3.inverse_z_0 = 1.0f / along_3;
    ray_3.shear_x_0 = component_0(direction_9, x_19) / along_3;
    ray_3.shear_y_0 = component_0(direction_9, y_6) / along_3;
    ray_3.t_min_0 = t_min_1;
    ray_3.t_max_0 = t_max_1;
    var _S1018 : f32 = abs(along_3);
    ray_3.local_per_t_0 = _S1018;
    ray_3.enter_0 = 0.0f;
    ray_3.edge_on_0 = limit_at_0(u32(0));
    ray_3.largest_1 = limit_at_0(u32(1));
    var view_5 : RayView_0;
    var _S1019 : vec3<f32> = direction_9 / vec3<f32>(_S1018);
    var axis_4 : u32 = u32(0);
    for(;;)
    {
        if(axis_4 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S1020 : f32 = max(abs(_S1019[axis_4]), 8.67361737988403547e-19f);
        var _S1021 : f32;
        if((_S1019[axis_4]) < 0.0f)
        {
            _S1021 = -1.0f / _S1020;
        }
        else
        {
            _S1021 = 1.0f / _S1020;
        }
        view_5.inverse_2[axis_4] = _S1021;
        axis_4 = axis_4 + u32(1);
    }
    var offset_4 : vec3<f32> = origin_1 * view_5.inverse_2;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_5.inverse_2);
    view_5.offset_near_0 = offset_4 + wider_0;
    view_5.offset_far_0 = offset_4 - wider_0;
    view_5.limit_0 = min(t_max_1 * ray_3.local_per_t_0, 8.0f) + 3.814697265625e-06f;
    view_5.margin_0 = 3.814697265625e-06f;
    view_5.axes_5 = (((x_19 | (((y_6 << (u32(2))))))) | (((z_4 << (u32(4))))));
    var found_4 : Found_0 = first_found_0(view_5, &(ray_3), any_1);
    (*t_4) = ray_3.t_max_0;
    return found_4;
}

fn cast_1( origin_2 : vec3<f32>,  direction_10 : vec3<f32>,  t_min_2 : f32,  t_max_2 : f32,  any_2 : bool,  t_5 : ptr<function, f32>) -> Found_0
{
    var size_2 : vec3<f32> = abs(direction_10);
    var _S1022 : f32 = size_2.x;
    var _S1023 : f32 = size_2.y;
    var _S1024 : bool;
    if(_S1022 >= _S1023)
    {
        _S1024 = _S1022 >= (size_2.z);
    }
    else
    {
        _S1024 = false;
    }
    var _S1025 : i32;
    if(_S1024)
    {
        _S1025 = i32(0);
    }
    else
    {
        if(_S1023 >= (size_2.z))
        {
            _S1025 = i32(1);
        }
        else
        {
            _S1025 = i32(2);
        }
    }
    var z_5 : u32 = u32(_S1025);
    var x_20 : u32 = (z_5 + u32(1)) % u32(3);
    var y_7 : u32 = (z_5 + u32(2)) % u32(3);
    var ray_4 : Ray_0;
    ray_4.origin_0 = origin_2;
    var along_4 : f32 = component_0(direction_10, z_5);
    ray_4.inverse_z_0 = 1.0f / along_4;
    ray_4.shear_x_0 = component_0(direction_10, x_20) / along_4;
    ray_4.shear_y_0 = component_0(direction_10, y_7) / along_4;
    ray_4.t_min_0 = t_min_2;
    ray_4.t_max_0 = t_max_2;
    var _S1026 : f32 = abs(along_4);
    ray_4.local_per_t_0 = _S1026;
    ray_4.enter_0 = 0.0f;
    ray_4.edge_on_0 = limit_at_0(u32(0));
    ray_4.largest_1 = limit_at_0(u32(1));
    var view_6 : RayView_0;
    var _S1027 : vec3<f32> = direction_10 / vec3<f32>(_S1026);
    var axis_5 : u32 = u32(0);
    for(;;)
    {
        if(axis_5 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S1028 : f32 = max(abs(_S1027[axis_5]), 8.67361737988403547e-19f);
        var _S1029 : f32;
        if((_S1027[axis_5]) < 0.0f)
        {
            _S1029 = -1.0f / _S1028;
        }
        else
        {
            _S1029 = 1.0f / _S1028;
        }
        view_6.inverse_2[axis_5] = _S1029;
        axis_5 = axis_5 + u32(1);
    }
    var offset_5 : vec3<f32> = origin_2 * view_6.inverse_2;
    var wider_1 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_6.inverse_2);
    view_6.offset_near_0 = offset_5 + wider_1;
    view_6.offset_far_0 = offset_5 - wider_1;
    view_6.limit_0 = min(t_max_2 * ray_4.local_per_t_0, 8.0f) + 3.814697265625e-06f;
    view_6.margin_0 = 3.814697265625e-06f;
    view_6.axes_5 = (((x_20 | (((y_7 << (u32(2))))))) | (((z_5 << (u32(4))))));
    var found_5 : Found_0 = first_found_0(view_6, &(ray_4), any_2);
    (*t_5) = ray_4.t_max_0;
    return found_5;
}

fn turning_0( vertex_1 : Vertex_0,  direction_11 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(0.0f);
}

fn towards_emitter_0( vertex_2 : Vertex_0,  direction_12 : vec3<f32>,  record_12 : u32) -> vec3<f32>
{
    var _S1030 : vec3<f32>;
    if((word_0(record_12)) == u32(1))
    {
        _S1030 = changing_0(direction_12, turning_0(vertex_2, direction_12));
    }
    else
    {
        _S1030 = still_0(direction_12);
    }
    return _S1030;
}

fn local_change_0( vertex_3 : Vertex_0,  direction_13 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(0.0f);
}

fn Mirrored_x24init_0( cosine_5 : f32,  pdf_4 : f32,  scattered_1 : f32) -> Mirrored_0
{
    var _S1031 : Mirrored_0;
    _S1031.cosine_0 = cosine_5;
    _S1031.pdf_1 = pdf_4;
    _S1031.scattered_0 = scattered_1;
    return _S1031;
}

fn facets_of_0( lobe_8 : Lobe_0,  numbers_4 : Numbers_0) -> Microfacets_0
{
    var facets_0 : Microfacets_0;
    facets_0.distribution_1 = lobe_8.distribution_0;
    facets_0.alpha_1 = max(numbers_4.alpha_0, vec2<f32>(0.00009999999747379f));
    return facets_0;
}

fn density_0( facets_1 : Microfacets_0,  m_0 : vec3<f32>) -> f32
{
    var _S1032 : f32 = m_0.z;
    if(_S1032 <= 0.0f)
    {
        return 0.0f;
    }
    var scale_2 : f32 = 3.14159274101257324f * facets_1.alpha_1.x * facets_1.alpha_1.y;
    var slope_3 : vec2<f32> = m_0.xy / facets_1.alpha_1;
    var spread_0 : f32 = dot(slope_3, slope_3);
    var cos2_6 : f32 = _S1032 * _S1032;
    if((facets_1.distribution_1) == u32(1))
    {
        var sum_5 : f32 = spread_0 + cos2_6;
        return 1.0f / (scale_2 * sum_5 * sum_5);
    }
    var exponent_2 : f32 = spread_0 / cos2_6;
    var _S1033 : f32;
    if(exponent_2 > 80.0f)
    {
        _S1033 = 0.0f;
    }
    else
    {
        _S1033 = exponential_0(- exponent_2) / (scale_2 * cos2_6 * cos2_6);
    }
    return _S1033;
}

fn visible_over_cos_0( facets_2 : Microfacets_0,  w_6 : vec3<f32>) -> f32
{
    var stretched_2 : vec2<f32> = w_6.xy * facets_2.alpha_1;
    var spread2_0 : f32 = dot(stretched_2, stretched_2);
    var _S1034 : f32 = w_6.z;
    var z2_3 : f32 = _S1034 * _S1034;
    if((facets_2.distribution_1) == u32(1))
    {
        return 2.0f / (_S1034 + sqrt(z2_3 + spread2_0));
    }
    if(z2_3 >= (36.0f * spread2_0))
    {
        return 1.0f / _S1034;
    }
    var spread_1 : f32 = sqrt(spread2_0);
    var both_0 : vec2<f32> = error_function_plus_one_0(_S1034 / spread_1);
    return 2.0f / (_S1034 * both_0.x + 0.5f * spread_1 * both_0.y);
}

fn mirrored_0( facets_3 : Microfacets_0,  wi_2 : vec3<f32>,  wo_1 : vec3<f32>) -> Mirrored_0
{
    var h_1 : vec3<f32> = normalize(wi_2 + wo_1);
    var mirrored_1 : Mirrored_0;
    mirrored_1.cosine_0 = dot(wi_2, h_1);
    var _S1035 : f32 = 0.25f * density_0(facets_3, h_1) * visible_over_cos_0(facets_3, wi_2);
    mirrored_1.pdf_1 = _S1035;
    mirrored_1.scattered_0 = _S1035 * visible_over_cos_0(facets_3, wo_1) * wo_1.z;
    return mirrored_1;
}

fn fresnel_conductor_channel_0( cosine_6 : f32,  eta_1 : f32,  k_4 : f32) -> f32
{
    var cos2_7 : f32 = cosine_6 * cosine_6;
    var sin2_2 : f32 = 1.0f - cos2_7;
    var real_2 : f32 = eta_1 * eta_1 - k_4 * k_4 - sin2_2;
    var product_4 : f32 = eta_1 * k_4;
    var modulus_0 : f32 = sqrt(real_2 * real_2 + 4.0f * (product_4 * product_4));
    if(modulus_0 == 0.0f)
    {
        return 1.0f;
    }
    var larger_0 : f32 = sqrt(0.5f * (modulus_0 + abs(real_2)));
    var smaller_2 : f32 = product_4 / larger_0;
    var _S1036 : bool = real_2 < 0.0f;
    var a_17 : f32;
    if(_S1036)
    {
        a_17 = smaller_2;
    }
    else
    {
        a_17 = larger_0;
    }
    var b_15 : f32;
    if(_S1036)
    {
        b_15 = larger_0;
    }
    else
    {
        b_15 = smaller_2;
    }
    var less_2 : f32 = a_17 - cosine_6;
    var more_2 : f32 = a_17 + cosine_6;
    var _S1037 : f32 = b_15 * b_15;
    var p_sum_4 : f32 = modulus_0 * cos2_7 + sin2_2 * sin2_2;
    return (less_2 * less_2 + _S1037) / (more_2 * more_2 + _S1037) * p_sum_4 / (p_sum_4 + 2.0f * a_17 * cosine_6 * sin2_2);
}

fn fresnel_conductor_0( cosine_7 : f32,  eta_2 : vec3<f32>,  k_5 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(fresnel_conductor_channel_0(cosine_7, eta_2.x, k_5.x), fresnel_conductor_channel_0(cosine_7, eta_2.y, k_5.y), fresnel_conductor_channel_0(cosine_7, eta_2.z, k_5.z));
}

fn coat_eta_0( numbers_5 : Numbers_0) -> f32
{
    return luminance_0(numbers_5.eta_0) / luminance_0(numbers_5.k_0);
}

fn fresnel_dielectric_0( cosine_8 : f32,  eta_3 : f32) -> f32
{
    var eta2_2 : f32 = eta_3 * eta_3;
    var cos2_8 : f32 = cosine_8 * cosine_8;
    var denser_2 : f32 = (eta_3 - 1.0f) * (eta_3 + 1.0f);
    var squared_5 : f32 = denser_2 + cos2_8;
    if(squared_5 <= 0.0f)
    {
        return 1.0f;
    }
    var refracted_0 : f32 = sqrt(squared_5);
    var s_sum_2 : f32 = cosine_8 + refracted_0;
    var p_sum_5 : f32 = eta2_2 * cosine_8 + refracted_0;
    var senkrecht_3 : f32 = denser_2 / (s_sum_2 * s_sum_2);
    var parallel_1 : f32 = denser_2 * ((eta2_2 + 1.0f) * cos2_8 - 1.0f) / (p_sum_5 * p_sum_5);
    return 0.5f * (senkrecht_3 * senkrecht_3 + parallel_1 * parallel_1);
}

fn transmittance_0( lobe_9 : Lobe_0,  eta_4 : f32,  cosine_9 : f32) -> f32
{
    if((lobe_9.kind_0) == u32(3))
    {
        return 1.0f - fresnel_dielectric_0(cosine_9, eta_4);
    }
    var place_14 : f32 = cosine_9 * 63.0f;
    var _S1038 : u32 = min(u32(place_14), u32(62));
    var at_17 : u32 = word_0(lobe_9.record_0 + u32(3)) + _S1038;
    var here_2 : f32 = number_0(at_17);
    return here_2 + (number_0(at_17 + u32(1)) - here_2) * (place_14 - f32(_S1038));
}

fn fresnel_diffuse_0( eta_5 : f32) -> f32
{
    var inverse_3 : f32 = 1.0f / eta_5;
    if(eta_5 < 1.0f)
    {
        return (-1.43990004062652588f * eta_5 + 0.70990002155303955f) * eta_5 + 0.66809999942779541f + 0.06360000371932983f * inverse_3;
    }
    return ((((-1.36881005764007568f * inverse_3 + 4.98553991317749023f) * inverse_3 - 7.80988979339599609f) * inverse_3 + 6.75334978103637695f) * inverse_3 - 3.47930002212524414f) * inverse_3 + 0.91931700706481934f;
}

fn base_0( lobe_10 : Lobe_0,  eta_6 : f32,  diffuse_0 : vec3<f32>) -> vec3<f32>
{
    var internal_reflectance_2 : f32;
    if((lobe_10.kind_0) == u32(3))
    {
        internal_reflectance_2 = fresnel_diffuse_0(1.0f / eta_6);
    }
    else
    {
        internal_reflectance_2 = number_0(word_0(lobe_10.record_0 + u32(3)) + u32(64));
    }
    if((word_0(lobe_10.record_0 + u32(2))) == u32(0))
    {
        return diffuse_0 * vec3<f32>((1.0f / (1.0f - internal_reflectance_2)));
    }
    return diffuse_0 / (vec3<f32>(1.0f) - diffuse_0 * vec3<f32>(internal_reflectance_2));
}

fn scattering_1( lobe_11 : Lobe_0,  numbers_6 : Numbers_0,  wi_3 : vec3<f32>,  wo_2 : vec3<f32>) -> Scattering_0
{
    var scattering_2 : Scattering_0;
    var _S1039 : f32 = wo_2.z;
    var by_cosine_2 : f32 = _S1039 * 0.31830987334251404f;
    if((lobe_11.kind_0) == u32(0))
    {
        scattering_2.value_1 = numbers_6.diffuse_reflectance_0 * vec3<f32>(by_cosine_2);
        scattering_2.pdf_0 = by_cosine_2;
        return scattering_2;
    }
    var _S1040 : Mirrored_0 = Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
    var by_facets_2 : Mirrored_0;
    if(is_rough_0(lobe_11))
    {
        by_facets_2 = mirrored_0(facets_of_0(lobe_11, numbers_6), wi_3, wo_2);
    }
    else
    {
        by_facets_2 = _S1040;
    }
    if((lobe_11.kind_0) == u32(2))
    {
        scattering_2.value_1 = numbers_6.specular_reflectance_0 * (fresnel_conductor_0(by_facets_2.cosine_0, numbers_6.eta_0, numbers_6.k_0) * vec3<f32>(by_facets_2.scattered_0));
        scattering_2.pdf_0 = by_facets_2.pdf_1;
        return scattering_2;
    }
    var eta_7 : f32 = coat_eta_0(numbers_6);
    var enters_1 : f32 = transmittance_0(lobe_11, eta_7, wi_3.z);
    scattering_2.value_1 = base_0(lobe_11, eta_7, numbers_6.diffuse_reflectance_0) * vec3<f32>((enters_1 * transmittance_0(lobe_11, eta_7, _S1039) * by_cosine_2 / (eta_7 * eta_7)));
    var probability_3 : f32 = base_probability_0(numbers_6, enters_1);
    scattering_2.pdf_0 = probability_3 * by_cosine_2;
    if((lobe_11.kind_0) == u32(4))
    {
        scattering_2.value_1 = scattering_2.value_1 + numbers_6.specular_reflectance_0 * vec3<f32>((fresnel_dielectric_0(by_facets_2.cosine_0, eta_7) * by_facets_2.scattered_0));
        scattering_2.pdf_0 = scattering_2.pdf_0 + (1.0f - probability_3) * by_facets_2.pdf_1;
    }
    return scattering_2;
}

struct Scattered_0
{
     value_9 : vec3<f32>,
     pdf_5 : f32,
};

fn eval_and_pdf_0( lobe_12 : Lobe_0,  wi_4 : vec3<f32>,  wo_3 : vec3<f32>) -> Scattered_0
{
    var scattered_2 : Scattered_0;
    scattered_2.value_9 = still_0(vec3<f32>(0.0f));
    scattered_2.pdf_5 = 0.0f;
    var _S1041 : bool;
    if((value_of_0(wo_3).z) <= 0.0f)
    {
        _S1041 = true;
    }
    else
    {
        _S1041 = !has_smooth_0(lobe_12);
    }
    if(_S1041)
    {
        return scattered_2;
    }
    var both_1 : Scattering_0 = scattering_1(lobe_12, lobe_12.numbers_0, wi_4, wo_3);
    scattered_2.value_9 = both_1.value_1;
    scattered_2.pdf_5 = both_1.pdf_0;
    return scattered_2;
}

fn scattered_to_0( vertex_4 : Vertex_0,  wo_4 : vec3<f32>,  direction_14 : vec3<f32>) -> Scattered_0
{
    return eval_and_pdf_0(vertex_4.lobe_6, vertex_4.wi_1, changing_0(wo_4, local_change_0(vertex_4, direction_14)));
}

fn met_0( vertex_5 : Vertex_0,  direction_15 : vec3<f32>,  t_6 : f32,  place_15 : Place_0) -> Place_0
{
    return place_15;
}

fn weight_over_0( own_2 : f32,  other_0 : f32) -> f32
{
    var ratio_0 : f32 = other_0 / own_2;
    if(ratio_0 > 9.9999998430674944e+17f)
    {
        return 0.0f;
    }
    return 1.0f / (own_2 * (1.0f + ratio_0 * ratio_0));
}

fn change_word_0( at_18 : u32) -> u32
{
    return input_0[u32(12) * launch_0.room_0 + at_18];
}

fn numbers_of_0( texture_5 : u32) -> u32
{
    return change_word_0(u32(2) * word_0(texture_5 + u32(12)));
}

fn units_of_0( texture_6 : u32) -> f32
{
    return (bitcast<f32>((change_word_0(u32(2) * word_0(texture_6 + u32(12)) + u32(1)))));
}

fn add_word_0( sum_6 : u32,  word_of_sum_0 : u32,  number_1 : u32,  is_negative_0 : bool)
{
    var _S1042 : u32 = u32(2) + u32(4) * sum_6;
    var _S1043 : u32 = number_1;
    var k_6 : u32 = word_of_sum_0;
    for(;;)
    {
        var _S1044 : bool;
        if(k_6 < u32(4))
        {
            _S1044 = _S1043 != u32(0);
        }
        else
        {
            _S1044 = false;
        }
        if(_S1044)
        {
        }
        else
        {
            break;
        }
        var _S1045 : u32;
        if(is_negative_0)
        {
            _S1045 = u32(0) - _S1043;
        }
        else
        {
            _S1045 = _S1043;
        }
        var before_0 : u32 = atomicAdd(&(sums_0[_S1042 + k_6]), _S1045);
        var overflows_0 : bool;
        if(is_negative_0)
        {
            overflows_0 = before_0 < _S1043;
        }
        else
        {
            overflows_0 = (before_0 + _S1043) < before_0;
        }
        var _S1046 : i32;
        if(overflows_0)
        {
            _S1046 = i32(1);
        }
        else
        {
            _S1046 = i32(0);
        }
        var _S1047 : u32 = u32(_S1046);
        var _S1048 : u32 = k_6 + u32(1);
        _S1043 = _S1047;
        k_6 = _S1048;
    }
    return;
}

fn add_to_sum_0( sum_7 : u32,  derivative_0 : f32,  units_0 : f32)
{
    if(!((abs(derivative_0)) < 3.00000000549775576e+38f))
    {
        var _S1049 : u32 = atomicAdd(&(sums_0[u32(1)]), u32(1));
        return;
    }
    var scaled_0 : f32 = derivative_0 * units_0;
    var size_3 : f32 = abs(scaled_0);
    if(size_3 > 7.73712524553362672e+25f)
    {
        var _S1050 : u32 = atomicAdd(&(sums_0[u32(0)]), u32(1));
        return;
    }
    var is_negative_1 : bool = scaled_0 < 0.0f;
    var highest_1 : u32 = u32(0);
    var size_4 : f32 = size_3;
    for(;;)
    {
        var _S1051 : bool;
        if(highest_1 < u32(2))
        {
            _S1051 = size_4 >= 4.294967296e+09f;
        }
        else
        {
            _S1051 = false;
        }
        if(_S1051)
        {
        }
        else
        {
            break;
        }
        var size_5 : f32 = size_4 * 2.32830643653869629e-10f;
        highest_1 = highest_1 + u32(1);
        size_4 = size_5;
    }
    var _S1052 : bool = highest_1 == u32(0);
    var _S1053 : f32;
    if(_S1052)
    {
        _S1053 = size_4 + 0.5f;
    }
    else
    {
        _S1053 = size_4;
    }
    var whole_0 : u32 = u32(_S1053);
    add_word_0(sum_7, highest_1, whole_0, is_negative_1);
    if(_S1052)
    {
        return;
    }
    var rest_7 : f32 = (size_4 - f32(whole_0)) * 4.294967296e+09f;
    var _S1054 : u32 = highest_1 - u32(1);
    if(highest_1 == u32(1))
    {
        size_4 = rest_7 + 0.5f;
    }
    else
    {
        size_4 = rest_7;
    }
    add_word_0(sum_7, _S1054, u32(size_4), is_negative_1);
    return;
}

fn add_to_texels_0( texture_7 : u32,  lookup_5 : Lookup_0,  derivative_1 : vec3<f32>)
{
    var first_3 : u32 = numbers_of_0(texture_7);
    if(first_3 == u32(4294967295))
    {
        return;
    }
    var _S1055 : f32 = units_of_0(texture_7);
    var _S1056 : u32 = word_0(texture_7 + u32(1));
    var k_7 : u32 = u32(0);
    for(;;)
    {
        if(k_7 < (lookup_5.count_0))
        {
        }
        else
        {
            break;
        }
        var at_19 : u32 = first_3 + _S1056 * lookup_5.texels_0[k_7];
        var own_3 : vec3<f32> = derivative_1 * vec3<f32>(lookup_5.weights_1[k_7]);
        if(_S1056 == u32(1))
        {
            add_to_sum_0(at_19, own_3.x + own_3.y + own_3.z, _S1055);
            k_7 = k_7 + u32(1);
            continue;
        }
        var axis_6 : u32 = u32(0);
        for(;;)
        {
            if(axis_6 < u32(3))
            {
            }
            else
            {
                break;
            }
            add_to_sum_0(at_19 + axis_6, own_3[axis_6], _S1055);
            axis_6 = axis_6 + u32(1);
        }
        k_7 = k_7 + u32(1);
    }
    return;
}

fn in_map_0( map_5 : u32,  direction_16 : vec3<f32>) -> Lookup_0
{
    var place_16 : vec2<f32> = map_place_0(map_5, direction_16);
    var point_1 : Point_0;
    point_1.value_5 = place_16;
    var x_21 : i32 = floor_of_0(place_16.x);
    var y_8 : i32 = floor_of_0(place_16.y);
    var width_3 : i32 = i32(word_0(map_5));
    var height_1 : i32 = i32(word_0(map_5 + u32(1)));
    var left_1 : u32 = wrapped_0(x_21, width_3, u32(0));
    var right_1 : u32 = wrapped_0(x_21 + i32(1), width_3, u32(0));
    var _S1057 : u32 = wrapped_0(y_8, height_1, u32(2));
    var _S1058 : u32 = u32(width_3);
    var first_4 : u32 = _S1057 * _S1058;
    var _S1059 : u32 = wrapped_0(y_8 + i32(1), height_1, u32(2));
    var second_2 : u32 = _S1059 * _S1058;
    return between_0(vec4<u32>(first_4 + left_1, first_4 + right_1, second_2 + left_1, second_2 + right_1), point_1);
}

fn emitted_0( emitter_5 : u32,  place_17 : Place_0,  direction_17 : vec3<f32>,  importance_0 : vec3<f32>) -> vec3<f32>
{
    var record_13 : u32 = emitter_record_0(emitter_5);
    var texture_8 : u32 = word_0(record_13 + u32(1));
    if(!is_map_0(record_13))
    {
        var lookup_6 : Lookup_0 = lookup_at_0(texture_8, place_17);
        add_to_texels_0(texture_8, lookup_6, importance_0);
        return looked_up_0(texture_8, lookup_6);
    }
    var texels_2 : u32 = word_0(texture_8 + u32(11));
    var scale_3 : u32 = word_0(texture_8 + u32(12));
    var lookup_7 : Lookup_0 = in_map_0(texture_8, direction_17);
    var seen_5 : vec3<f32> = looked_up_0(texels_2, lookup_7);
    var _S1060 : Lookup_0 = one_texel_0(u32(0));
    var factor_1 : vec3<f32> = looked_up_0(scale_3, _S1060);
    add_to_texels_0(texels_2, lookup_7, importance_0 * factor_1);
    add_to_texels_0(scale_3, _S1060, importance_0 * seen_5);
    return seen_5 * factor_1;
}

fn specular_fraction_0( lobe_13 : Lobe_0,  numbers_7 : Numbers_0,  wi_5 : vec3<f32>) -> vec3<f32>
{
    if((lobe_13.kind_0) == u32(1))
    {
        return numbers_7.specular_reflectance_0 * fresnel_conductor_0(wi_5.z, numbers_7.eta_0, numbers_7.k_0);
    }
    return numbers_7.specular_reflectance_0 * vec3<f32>(fresnel_dielectric_0(wi_5.z, coat_eta_0(numbers_7)));
}

fn add_back_0( sum_8 : ptr<function, Numbers_0>,  lobe_14 : Lobe_0,  wi_6 : vec3<f32>,  wo_5 : vec3<f32>,  is_specular_1 : bool,  importance_1 : vec3<f32>)
{
    var _S1061 : Numbers_0 = no_numbers_0();
    var numbers_8 : DiffPair_Numbers_0;
    numbers_8.primal_0 = lobe_14.numbers_0;
    numbers_8.differential_0 = _S1061;
    var _S1062 : vec3<f32> = vec3<f32>(0.0f);
    var towards_viewer_1 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    towards_viewer_1.primal_0 = wi_6;
    towards_viewer_1.differential_0 = _S1062;
    var onward_1 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    onward_1.primal_0 = wo_5;
    onward_1.differential_0 = _S1062;
    if(is_specular_1)
    {
        _S861(lobe_14, &(numbers_8), &(towards_viewer_1), importance_1);
    }
    else
    {
        var of_value_0 : Scattering_Differential_0;
        of_value_0.value_0 = importance_1;
        _S803(lobe_14, &(numbers_8), &(towards_viewer_1), &(onward_1), of_value_0);
    }
    (*sum_8) = Numbers_x24_syn_dadd_0((*sum_8), numbers_8.differential_0);
    return;
}

fn add_light_from_emitter_0( reflected_1 : ptr<function, Reflected_0>,  vertex_6 : Vertex_0,  choice_5 : Choice_0,  key_7 : vec2<u32>,  first_5 : u32,  bsdf_samples_0 : f32,  importance_2 : vec3<f32>)
{
    var probability_4 : f32;
    var emitter_6 : u32 = chosen_emitter_0(choice_5, random_0(key_7, first_5), &(probability_4));
    if(probability_4 == 0.0f)
    {
        return;
    }
    var record_14 : u32 = emitter_record_0(emitter_6);
    var point_2 : EmitterPoint_0;
    var nearest_0 : f32 = limit_at_0(u32(2));
    var direction_18 : vec3<f32>;
    var way_2 : vec3<f32>;
    var farthest_0 : f32;
    var distance_4 : f32;
    var nearest_1 : f32;
    if(is_area_0(record_14))
    {
        point_2 = area_point_0(record_14, vertex_6.surface_2, key_7, first_5 + u32(1));
        if(!((point_2.pdf_2) > 0.0f))
        {
            return;
        }
        var way_3 : vec3<f32> = position_of_0(point_2.place_12) - vertex_6.surface_2.exact_0;
        var distance_5 : f32 = length(way_3);
        var nearest_2 : f32 = nearest_0 / distance_5;
        var _S1063 : f32 = limit_at_0(u32(3));
        direction_18 = way_3 / vec3<f32>(distance_5);
        way_2 = way_3;
        farthest_0 = _S1063;
        distance_4 = distance_5;
        nearest_1 = nearest_2;
    }
    else
    {
        if(is_map_0(record_14))
        {
            var _S1064 : u32 = word_0(record_14 + u32(1));
            var _S1065 : u32 = first_5 + u32(1);
            var _S1066 : f32 = point_2.pdf_2;
            var _S1067 : vec3<f32> = sample_map_0(_S1064, key_7, _S1065, &(_S1066));
            point_2.pdf_2 = _S1066;
            direction_18 = _S1067;
        }
        else
        {
            var local_1 : vec3<f32> = sample_cosine_0(random_pair_0(key_7, first_5 + u32(1)));
            var _S1068 : vec3<f32> = normalize(to_world_0(vertex_6.axes_3, local_1));
            point_2.pdf_2 = local_1.z * 0.31830987334251404f;
            direction_18 = _S1068;
        }
        point_2.place_12 = vertex_6.surface_2.place_5;
        var _S1069 : f32 = limit_at_0(u32(1));
        way_2 = direction_18;
        farthest_0 = _S1069;
        distance_4 = 0.0f;
        nearest_1 = nearest_0;
    }
    var wo_6 : vec3<f32> = to_local_0(vertex_6.axes_3, direction_18);
    if((wo_6.z) <= 0.0f)
    {
        return;
    }
    var unused_0 : f32;
    if((cast_0(vertex_6.surface_2.exact_0, way_2, nearest_1, farthest_0, true, &(unused_0)).face_7) != u32(4294967295))
    {
        return;
    }
    var own_4 : f32 = f32(word_0(u32(2))) * probability_4 * point_2.pdf_2;
    if(!(own_4 > 0.0f))
    {
        return;
    }
    var moving_0 : vec3<f32> = towards_emitter_0(vertex_6, direction_18, record_14);
    var scattered_3 : Scattered_0 = scattered_to_0(vertex_6, wo_6, moving_0);
    var place_18 : Place_0 = point_2.place_12;
    var place_19 : Place_0;
    if(is_area_0(record_14))
    {
        place_19 = met_0(vertex_6, moving_0, distance_4, place_18);
    }
    else
    {
        place_19 = place_18;
    }
    var _S1070 : vec3<f32> = vec3<f32>(weight_over_0(own_4, bsdf_samples_0 * scattered_3.pdf_5));
    var _S1071 : vec3<f32> = emitted_0(emitter_6, place_19, moving_0, importance_2 * value_of_0(scattered_3.value_9) * _S1070);
    var light_1 : vec3<f32> = _S1071 * _S1070;
    (*reflected_1).direct_0 = (*reflected_1).direct_0 + scattered_3.value_9 * light_1;
    var _S1072 : vec3<f32> = importance_2 * light_1;
    var _S1073 : Numbers_0 = (*reflected_1).by_emitters_0;
    add_back_0(&(_S1073), vertex_6.lobe_6, vertex_6.wi_1, wo_6, false, _S1072);
    (*reflected_1).by_emitters_0 = _S1073;
    return;
}

struct Stretched_0
{
     sine_4 : f32,
     cosine_10 : f32,
     around_0 : vec2<f32>,
     length_0 : f32,
};

fn stretched_3( facets_4 : Microfacets_0,  wi_7 : vec3<f32>) -> Stretched_0
{
    var longer_0 : vec3<f32> = vec3<f32>(wi_7.xy * facets_4.alpha_1, wi_7.z);
    var view_7 : Stretched_0;
    var _S1074 : f32 = length(longer_0);
    view_7.length_0 = _S1074;
    var longer_1 : vec3<f32> = longer_0 / vec3<f32>(_S1074);
    var _S1075 : vec2<f32> = longer_1.xy;
    var _S1076 : f32 = length(_S1075);
    view_7.sine_4 = _S1076;
    view_7.cosine_10 = longer_1.z;
    var _S1077 : vec2<f32>;
    if(_S1076 > 0.0f)
    {
        _S1077 = _S1075 / vec2<f32>(view_7.sine_4);
    }
    else
    {
        _S1077 = vec2<f32>(1.0f, 0.0f);
    }
    view_7.around_0 = _S1077;
    return view_7;
}

fn ggx_normal_0( view_8 : Stretched_0,  u_9 : vec2<f32>) -> vec3<f32>
{
    var _S1078 : f32 = u_9.x;
    var radius_2 : f32 = sqrt(_S1078);
    var turn_3 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_9.y);
    var across_1 : f32 = radius_2 * turn_3.y;
    var along_5 : f32 = radius_2 * turn_3.x;
    var visible_0 : f32 = 0.5f * (1.0f + view_8.cosine_10);
    var hidden_0 : f32 = 1.0f - visible_0;
    var _S1079 : f32 = 1.0f - _S1078;
    var edge_0 : f32 = sqrt(_S1079 + along_5 * along_5);
    var up_0 : f32 = hidden_0 * edge_0 + visible_0 * along_5;
    var from_top_0 : f32 = edge_0 - along_5;
    var from_bottom_0 : f32 = edge_0 + along_5;
    var from_top_1 : f32;
    var from_bottom_1 : f32;
    if(along_5 > 0.0f)
    {
        from_top_1 = _S1079 / from_bottom_0;
        from_bottom_1 = from_bottom_0;
    }
    else
    {
        var _S1080 : f32 = _S1079 / from_top_0;
        from_top_1 = from_top_0;
        from_bottom_1 = _S1080;
    }
    var towards_0 : f32 = sqrt(visible_0 * from_top_1 * (2.0f * hidden_0 * edge_0 + visible_0 * from_bottom_1));
    return vec3<f32>(towards_0 * view_8.sine_4 - up_0 * view_8.cosine_10, across_1, max(towards_0 * view_8.cosine_10 + up_0 * view_8.sine_4, 0.0f));
}

fn logarithm_0( x_22 : f32) -> f32
{
    var bits_0 : u32 = (bitcast<u32>((x_22)));
    var power_3 : f32 = f32(i32((bits_0 >> (u32(23)))) - i32(126));
    var m_1 : f32 = (bitcast<f32>(((((bits_0 & (u32(8388607)))) | (u32(1056964608))))));
    var m_2 : f32;
    var power_4 : f32;
    if(m_1 < 0.70710676908493042f)
    {
        var power_5 : f32 = power_3 - 1.0f;
        m_2 = m_1 + m_1;
        power_4 = power_5;
    }
    else
    {
        m_2 = m_1;
        power_4 = power_3;
    }
    var m_3 : f32 = m_2 - 1.0f;
    var z_6 : f32 = m_3 * m_3;
    return m_3 + (((((((((0.07037683576345444f * m_3 - 0.11514610052108765f) * m_3 + 0.11676998436450958f) * m_3 - 0.12420140951871872f) * m_3 + 0.14249323308467865f) * m_3 - 0.16668057441711426f) * m_3 + 0.20000714063644409f) * m_3 - 0.24999994039535522f) * m_3 + 0.33333331346511841f) * m_3 * z_6 - 0.00021219444170129f * power_4 - 0.5f * z_6) + 0.693359375f * power_4;
}

fn error_function_inverse_0( p_0 : f32) -> f32
{
    var w_7 : f32 = - logarithm_0((1.0f - p_0) * (1.0f + p_0));
    if(w_7 < 5.0f)
    {
        var w_8 : f32 = w_7 - 2.5f;
        return ((((((((2.81022636272609816e-08f * w_8 + 3.43273939051869093e-07f) * w_8 - 3.52338770426285919e-06f) * w_8 - 4.39150653619435616e-06f) * w_8 + 0.00021858086984139f) * w_8 - 0.00125372502952814f) * w_8 - 0.00417768163606524f) * w_8 + 0.24664072692394257f) * w_8 + 1.50140941143035889f) * p_0;
    }
    var w_9 : f32 = sqrt(w_7) - 3.0f;
    return ((((((((-0.0002002142573474f * w_9 + 0.00010095055768033f) * w_9 + 0.00134934321977198f) * w_9 - 0.00367342843674123f) * w_9 + 0.00573950773105025f) * w_9 - 0.00762246130034328f) * w_9 + 0.00943887047469616f) * w_9 + 1.00167405605316162f) * w_9 + 2.8329768180847168f) * p_0;
}

fn beckmann_normal_0( view_9 : Stretched_0,  visible_1 : f32,  u_10 : vec2<f32>) -> vec3<f32>
{
    var steepest_0 : f32;
    if((view_9.sine_4 * 6.0f) > (view_9.cosine_10))
    {
        steepest_0 = view_9.cosine_10 / view_9.sine_4;
    }
    else
    {
        steepest_0 = 6.0f;
    }
    var target_1 : f32 = u_10.x * (2.0f / (visible_1 * view_9.length_0));
    var _S1081 : f32 = max(view_9.cosine_10, view_9.sine_4);
    var slope_4 : f32 = clamp(error_function_inverse_0(clamp(target_1 / _S1081 - 1.0f, -0.99999994039535522f, 0.99999994039535522f)) + -0.5f * view_9.sine_4 / _S1081, -6.0f, 0.5f * steepest_0);
    var low_5 : f32 = -6.0f;
    var high_2 : f32 = steepest_0;
    var step_0 : u32 = u32(0);
    for(;;)
    {
        if(step_0 < u32(32))
        {
        }
        else
        {
            break;
        }
        var both_2 : vec2<f32> = error_function_plus_one_0(slope_4);
        var _S1082 : f32 = both_2.y;
        var error_0 : f32 = view_9.cosine_10 * both_2.x + 0.5f * view_9.sine_4 * _S1082 - target_1;
        var own_5 : f32 = _S1082 * (view_9.cosine_10 - slope_4 * view_9.sine_4);
        var bend_0 : f32 = -2.0f * slope_4 * own_5 - _S1082 * view_9.sine_4;
        if(error_0 > 0.0f)
        {
            high_2 = slope_4;
        }
        else
        {
            low_5 = slope_4;
        }
        var next_1 : f32 = slope_4 - error_0 * own_5 / (own_5 * own_5 - 0.5f * error_0 * bend_0);
        var _S1083 : bool;
        if(next_1 >= low_5)
        {
            _S1083 = next_1 <= high_2;
        }
        else
        {
            _S1083 = false;
        }
        var next_2 : f32;
        if(!_S1083)
        {
            next_2 = 0.5f * (low_5 + high_2);
        }
        else
        {
            next_2 = next_1;
        }
        if((abs(next_2 - slope_4)) < 0.00030000001424924f)
        {
            slope_4 = next_2;
            break;
        }
        var _S1084 : u32 = step_0 + u32(1);
        slope_4 = next_2;
        step_0 = _S1084;
    }
    return vec3<f32>(- slope_4, error_function_inverse_0(max(2.0f * u_10.y - 1.0f, -0.99999994039535522f)), 1.0f);
}

fn mirrored_at_facet_0( facets_5 : Microfacets_0,  wi_8 : vec3<f32>,  u_11 : vec2<f32>) -> vec3<f32>
{
    var view_10 : Stretched_0 = stretched_3(facets_5, wi_8);
    var normal_7 : vec3<f32>;
    if((facets_5.distribution_1) == u32(1))
    {
        normal_7 = ggx_normal_0(view_10, u_11);
    }
    else
    {
        normal_7 = beckmann_normal_0(view_10, visible_over_cos_0(facets_5, wi_8), u_11);
    }
    var _S1085 : f32 = view_10.around_0.x;
    var _S1086 : f32 = normal_7.x;
    var _S1087 : f32 = view_10.around_0.y;
    var _S1088 : f32 = normal_7.y;
    var normal_8 : vec3<f32> = normalize(vec3<f32>(vec2<f32>(_S1085 * _S1086 - _S1087 * _S1088, _S1087 * _S1086 + _S1085 * _S1088) * facets_5.alpha_1, normal_7.z));
    return normalize(normal_8 * vec3<f32>((2.0f * dot(wi_8, normal_8))) - wi_8);
}

struct Drawn_0
{
     wo_7 : vec3<f32>,
     is_specular_2 : bool,
     probability_5 : f32,
};

fn draw_0( lobe_15 : Lobe_0,  wi_9 : vec3<f32>,  choice_6 : f32,  u_12 : vec2<f32>) -> Drawn_0
{
    var _S1089 : bool = (lobe_15.kind_0) == u32(0);
    var has_base_0 : bool;
    if(_S1089)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_15.kind_0) == u32(3);
    }
    if(has_base_0)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_15.kind_0) == u32(4);
    }
    var of_base_1 : f32;
    if(_S1089)
    {
        of_base_1 = 1.0f;
    }
    else
    {
        of_base_1 = 0.0f;
    }
    var _S1090 : bool;
    if((lobe_15.kind_0) == u32(3))
    {
        _S1090 = true;
    }
    else
    {
        _S1090 = (lobe_15.kind_0) == u32(4);
    }
    if(_S1090)
    {
        of_base_1 = base_probability_0(lobe_15.numbers_0, transmittance_0(lobe_15, coat_eta_0(lobe_15.numbers_0), wi_9.z));
    }
    var drawn_0 : Drawn_0;
    drawn_0.is_specular_2 = false;
    drawn_0.probability_5 = 1.0f;
    if(has_base_0)
    {
        has_base_0 = choice_6 < of_base_1;
    }
    else
    {
        has_base_0 = false;
    }
    if(has_base_0)
    {
        drawn_0.wo_7 = sample_cosine_0(u_12);
    }
    else
    {
        if(is_rough_0(lobe_15))
        {
            drawn_0.wo_7 = mirrored_at_facet_0(facets_of_0(lobe_15, lobe_15.numbers_0), wi_9, u_12);
        }
        else
        {
            drawn_0.wo_7 = vec3<f32>((vec2<f32>(0) - wi_9.xy), wi_9.z);
            drawn_0.is_specular_2 = true;
            drawn_0.probability_5 = 1.0f - of_base_1;
        }
    }
    return drawn_0;
}

fn specular_direction_0( vertex_7 : Vertex_0,  direction_19 : vec3<f32>,  wo_8 : vec3<f32>) -> vec3<f32>
{
    return direction_19;
}

fn specular_0( lobe_16 : Lobe_0,  wi_10 : vec3<f32>) -> vec3<f32>
{
    return specular_fraction_0(lobe_16, lobe_16.numbers_0, wi_10);
}

fn first_from_0( position_6 : vec3<f32>,  direction_20 : vec3<f32>,  t_7 : ptr<function, f32>) -> Found_0
{
    var _S1091 : Found_0 = cast_1(position_6, direction_20, limit_at_0(u32(2)), limit_at_0(u32(1)), false, &((*t_7)));
    return _S1091;
}

fn place_of_0( found_6 : Found_0) -> Place_0
{
    return place_at_0(found_6.triangle_7, found_6.v_10, found_6.w_5);
}

fn emitter_seen_0( found_7 : Found_0,  direction_21 : vec3<f32>) -> u32
{
    if((found_7.face_7) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_7 : u32 = word_0(shape_of_0(found_7.triangle_7) + u32(4));
    var _S1092 : bool;
    if(emitter_7 != u32(4294967295))
    {
        _S1092 = (dot(cross_of_0(found_7.triangle_7), direction_21)) < 0.0f;
    }
    else
    {
        _S1092 = false;
    }
    var _S1093 : u32;
    if(_S1092)
    {
        _S1093 = emitter_7;
    }
    else
    {
        _S1093 = u32(4294967295);
    }
    return _S1093;
}

fn area_pdf_0( record_15 : u32,  face_8 : u32,  from_2 : Surface_0,  direction_22 : vec3<f32>,  distance_6 : f32) -> f32
{
    var own_6 : f32;
    var rectangle_1 : u32 = word_0(record_15 + u32(4));
    if(rectangle_1 != u32(4294967295))
    {
        var _S1094 : SeenRectangle_0 = seen_rectangle_0(rectangle_1, from_2.position_0);
        if(!((_S1094.solid_angle_0) > 0.0f))
        {
            return 0.0f;
        }
        if((_S1094.solid_angle_0) >= 0.00100000004749745f)
        {
            return 1.0f / _S1094.solid_angle_0;
        }
    }
    var _S1095 : u32 = word_0(word_0(record_15 + u32(7)) + face_8);
    var nodes_at_2 : u32 = word_0(record_15 + u32(5));
    var node_6 : u32 = nodes_at_2;
    var chosen_2 : f32 = 1.0f;
    for(;;)
    {
        if((word_0(node_6 + u32(2))) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var shares_1 : vec2<f32> = shares_of_0(nodes_at_2, node_6, from_2.position_0);
        var is_second_1 : bool = _S1095 >= (word_0(nodes_at_2 + u32(17) * word_0(node_6 + u32(3))));
        if(is_second_1)
        {
            own_6 = shares_1.y;
        }
        else
        {
            own_6 = shares_1.x;
        }
        var chosen_3 : f32 = chosen_2 * own_6;
        var _S1096 : i32;
        if(is_second_1)
        {
            _S1096 = i32(3);
        }
        else
        {
            _S1096 = i32(2);
        }
        node_6 = nodes_at_2 + u32(17) * word_0(node_6 + u32(_S1096));
        chosen_2 = chosen_3;
    }
    var _S1097 : u32 = word_0(record_15 + u32(6));
    var _S1098 : u32 = word_0(node_6);
    own_6 = 0.0f;
    var k_8 : u32 = _S1098;
    var total_3 : f32 = 0.0f;
    for(;;)
    {
        if(k_8 < (word_0(node_6 + u32(1))))
        {
        }
        else
        {
            break;
        }
        var angle_4 : f32 = face_solid_angle_0(record_15, word_0(_S1097 + k_8), from_2.exact_0);
        var total_4 : f32 = total_3 + angle_4;
        if(k_8 == _S1095)
        {
            own_6 = angle_4;
        }
        k_8 = k_8 + u32(1);
        total_3 = total_4;
    }
    if(!(own_6 > 0.0f))
    {
        return 0.0f;
    }
    return chosen_2 / total_3 * density_of_0(own_6, cross_of_0(emitter_triangle_0(record_15, face_8)), distance_6, direction_22);
}

fn emitter_pdf_0( emitter_8 : u32,  found_8 : Found_0,  vertex_8 : Vertex_0,  direction_23 : vec3<f32>,  t_8 : f32) -> f32
{
    var record_16 : u32 = emitter_record_0(emitter_8);
    if(is_map_0(record_16))
    {
        var _S1099 : f32 = map_pdf_0(word_0(record_16 + u32(1)), direction_23);
        return _S1099;
    }
    if(!is_area_0(record_16))
    {
        return max(dot(vertex_8.axes_3.n_1, direction_23), 0.0f) * 0.31830987334251404f;
    }
    return area_pdf_0(record_16, found_8.face_7 - word_0(record_16 + u32(3)), vertex_8.surface_2, direction_23, t_8);
}

fn take_further_0( path_6 : ptr<function, Path_0>,  reflected_2 : ptr<function, Reflected_0>,  importance_3 : vec3<f32>) -> bool
{
    var depth_2 : u32 = launch_0.depth_0;
    var first_6 : u32 = vertex_numbers_0(launch_0.depth_0);
    var surface_4 : Surface_0 = surface_at_0((*path_6).place_3, value_of_0((*path_6).direction_0));
    var material_1 : u32 = material_of_0(surface_4);
    if(material_1 == u32(4294967295))
    {
        return false;
    }
    var vertex_9 : Vertex_0 = vertex_at_0(surface_4, material_1, (*path_6).direction_0);
    var emitter_samples_0 : u32 = word_0(u32(2));
    var _S1100 : u32 = word_0(u32(3));
    var _S1101 : bool = !reaches_0(depth_2 + u32(3));
    var goes_on_0 : bool;
    if(_S1101)
    {
        goes_on_0 = (vertex_9.lobe_6.kind_0) == u32(0);
    }
    else
    {
        goes_on_0 = false;
    }
    if(goes_on_0)
    {
        goes_on_0 = is_sampled_well_0(surface_4.position_0);
    }
    else
    {
        goes_on_0 = false;
    }
    var bsdf_samples_1 : u32;
    if(goes_on_0)
    {
        bsdf_samples_1 = u32(0);
    }
    else
    {
        bsdf_samples_1 = _S1100;
    }
    var on_emitters_0 : u32;
    if(has_smooth_0(vertex_9.lobe_6))
    {
        on_emitters_0 = emitter_samples_0;
    }
    else
    {
        on_emitters_0 = u32(0);
    }
    var _S1102 : Choice_0 = choice_at_0(surface_4.position_0, vertex_9.axes_3.n_1, on_emitters_0 == u32(0));
    var i_4 : u32 = u32(0);
    for(;;)
    {
        if(i_4 < on_emitters_0)
        {
        }
        else
        {
            break;
        }
        add_light_from_emitter_0(&((*reflected_2)), vertex_9, _S1102, (*path_6).key_0, first_6 + u32(3) * i_4, f32(bsdf_samples_1), importance_3);
        i_4 = i_4 + u32(1);
    }
    var first_7 : u32 = first_6 + u32(3) * emitter_samples_0;
    goes_on_0 = false;
    var next_3 : Place_0 = (*path_6).place_3;
    var next_direction_0 : vec3<f32> = (*path_6).direction_0;
    var k_9 : u32 = u32(0);
    for(;;)
    {
        if(k_9 < bsdf_samples_1)
        {
        }
        else
        {
            break;
        }
        var own_first_0 : u32 = first_7 + u32(3) * k_9;
        var wi_11 : vec3<f32> = value_of_0(vertex_9.wi_1);
        var drawn_1 : Drawn_0 = draw_0(vertex_9.lobe_6, wi_11, random_0((*path_6).key_0, own_first_0), random_pair_0((*path_6).key_0, own_first_0 + u32(1)));
        var direction_24 : vec3<f32> = normalize(to_world_0(vertex_9.axes_3, drawn_1.wo_7));
        var moving_1 : vec3<f32>;
        if(drawn_1.is_specular_2)
        {
            moving_1 = specular_direction_0(vertex_9, direction_24, drawn_1.wo_7);
        }
        else
        {
            moving_1 = changing_0(direction_24, turning_0(vertex_9, direction_24));
        }
        var scattered_4 : Scattered_0;
        if(drawn_1.is_specular_2)
        {
            scattered_4.value_9 = specular_0(vertex_9.lobe_6, vertex_9.wi_1);
            scattered_4.pdf_5 = drawn_1.probability_5;
        }
        else
        {
            scattered_4 = scattered_to_0(vertex_9, drawn_1.wo_7, moving_1);
        }
        if(!((scattered_4.pdf_5) > 0.0f))
        {
            k_9 = k_9 + u32(1);
            continue;
        }
        var t_9 : f32;
        var found_9 : Found_0 = first_from_0(surface_4.exact_0, direction_24, &(t_9));
        var goes_on_1 : bool;
        var next_4 : Place_0;
        var next_direction_1 : vec3<f32>;
        if(k_9 == u32(0))
        {
            var _S1103 : bool = (found_9.face_7) != u32(4294967295);
            var _S1104 : Place_0 = place_of_0(found_9);
            (*reflected_2).onward_0 = scattered_4.value_9 * vec3<f32>((1.0f / scattered_4.pdf_5));
            (*reflected_2).wo_0 = drawn_1.wo_7;
            (*reflected_2).is_specular_0 = drawn_1.is_specular_2;
            (*reflected_2).factor_0 = 1.0f / scattered_4.pdf_5;
            goes_on_1 = _S1103;
            next_4 = _S1104;
            next_direction_1 = moving_1;
        }
        else
        {
            goes_on_1 = goes_on_0;
            next_4 = next_3;
            next_direction_1 = next_direction_0;
        }
        var emitter_9 : u32 = emitter_seen_0(found_9, direction_24);
        if(emitter_9 == u32(4294967295))
        {
            goes_on_0 = goes_on_1;
            next_3 = next_4;
            next_direction_0 = next_direction_1;
            k_9 = k_9 + u32(1);
            continue;
        }
        var own_7 : f32 = f32(bsdf_samples_1) * scattered_4.pdf_5;
        var _S1105 : bool = !drawn_1.is_specular_2;
        var _S1106 : bool;
        if(_S1105)
        {
            _S1106 = emitter_samples_0 != u32(0);
        }
        else
        {
            _S1106 = false;
        }
        var other_1 : f32;
        if(_S1106)
        {
            var pdf_6 : f32 = emitter_pdf_0(emitter_9, found_9, vertex_9, direction_24, t_9);
            other_1 = f32(emitter_samples_0) * chance_of_0(emitter_9, _S1102) * pdf_6;
        }
        else
        {
            other_1 = 0.0f;
        }
        var moving_2 : vec3<f32>;
        if(_S1105)
        {
            moving_2 = towards_emitter_0(vertex_9, direction_24, emitter_record_0(emitter_9));
        }
        else
        {
            moving_2 = moving_1;
        }
        var place_20 : Place_0 = place_of_0(found_9);
        var place_21 : Place_0;
        if((found_9.face_7) != u32(4294967295))
        {
            place_21 = met_0(vertex_9, moving_2, t_9, place_20);
        }
        else
        {
            place_21 = place_20;
        }
        var _S1107 : vec3<f32> = vec3<f32>(weight_over_0(own_7, other_1));
        var _S1108 : vec3<f32> = emitted_0(emitter_9, place_21, moving_2, importance_3 * value_of_0(scattered_4.value_9) * _S1107);
        var light_2 : vec3<f32> = _S1108 * _S1107;
        (*reflected_2).direct_0 = (*reflected_2).direct_0 + scattered_4.value_9 * light_2;
        var _S1109 : vec3<f32> = importance_3 * light_2;
        var _S1110 : Numbers_0 = (*reflected_2).by_emitters_0;
        add_back_0(&(_S1110), vertex_9.lobe_6, wi_11, drawn_1.wo_7, drawn_1.is_specular_2, _S1109);
        (*reflected_2).by_emitters_0 = _S1110;
        goes_on_0 = goes_on_1;
        next_3 = next_4;
        next_direction_0 = next_direction_1;
        k_9 = k_9 + u32(1);
    }
    if(_S1101)
    {
        goes_on_0 = true;
    }
    else
    {
        goes_on_0 = !goes_on_0;
    }
    if(goes_on_0)
    {
        return false;
    }
    var throughput_1 : vec3<f32> = value_of_0((*path_6).throughput_0) * value_of_0((*reflected_2).onward_0);
    var _S1111 : f32 = max(max(throughput_1.x, throughput_1.y), throughput_1.z);
    var _S1112 : u32 = depth_2 + u32(1);
    if(_S1112 >= (word_0(u32(1))))
    {
        var survival_0 : f32 = clamp(_S1111, 0.05000000074505806f, 0.94999998807907104f);
        if((random_0((*path_6).key_0, vertex_numbers_0(_S1112) - u32(1))) >= survival_0)
        {
            return false;
        }
        (*reflected_2).onward_0 = (*reflected_2).onward_0 * vec3<f32>((1.0f / survival_0));
        (*reflected_2).factor_0 = (*reflected_2).factor_0 / survival_0;
    }
    (*path_6).place_3 = next_3;
    (*path_6).direction_0 = next_direction_0;
    return true;
}

fn slot_derivative_0( numbers_9 : Numbers_0,  slot_6 : u32) -> vec3<f32>
{
    switch(slot_6)
    {
    case u32(0):
        {
            return numbers_9.diffuse_reflectance_0;
        }
    case u32(1):
        {
            return numbers_9.specular_reflectance_0;
        }
    case u32(2):
        {
            return numbers_9.eta_0;
        }
    case u32(3):
        {
            return numbers_9.k_0;
        }
    case u32(4):
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_9.alpha_0.x);
        }
    default :
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_9.alpha_0.y);
        }
    }
}

fn add_to_textures_0( material_2 : u32,  place_22 : Place_0,  numbers_10 : Numbers_0)
{
    var _S1113 : u32 = word_0(material_2 + u32(4));
    var slot_7 : u32 = u32(0);
    for(;;)
    {
        if(slot_7 < _S1113)
        {
        }
        else
        {
            break;
        }
        var texture_9 : u32 = word_0(material_2 + u32(5) + slot_7);
        var _S1114 : bool;
        if(texture_9 == u32(4294967295))
        {
            _S1114 = true;
        }
        else
        {
            _S1114 = (numbers_of_0(texture_9)) == u32(4294967295);
        }
        if(_S1114)
        {
            slot_7 = slot_7 + u32(1);
            continue;
        }
        var _S1115 : Lookup_0 = lookup_at_0(texture_9, place_22);
        add_to_texels_0(texture_9, _S1115, slot_derivative_0(numbers_10, slot_7));
        slot_7 = slot_7 + u32(1);
    }
    return;
}

fn kept_at_0() -> u32
{
    return u32(18) + u32(20) * launch_0.depth_0;
}

fn set_word_0( path_7 : u32,  which_6 : u32,  value_10 : u32)
{
    paths_0[which_6 * launch_0.room_0 + path_7] = value_10;
    return;
}

fn set_vector_0( path_8 : u32,  which_7 : ptr<function, u32>,  value_11 : vec3<f32>)
{
    var axis_7 : u32 = u32(0);
    for(;;)
    {
        if(axis_7 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_8, (*which_7) + axis_7, (bitcast<u32>((value_11[axis_7]))));
        axis_7 = axis_7 + u32(1);
    }
    (*which_7) = (*which_7) + u32(3);
    return;
}

fn set_vector_1( path_9 : u32,  which_8 : ptr<function, u32>,  value_12 : vec3<f32>)
{
    var axis_8 : u32 = u32(0);
    for(;;)
    {
        if(axis_8 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_9, (*which_8) + axis_8, (bitcast<u32>((value_12[axis_8]))));
        axis_8 = axis_8 + u32(1);
    }
    (*which_8) = (*which_8) + u32(3);
    return;
}

fn set_vector_2( path_10 : u32,  which_9 : ptr<function, u32>,  value_13 : vec3<f32>)
{
    var axis_9 : u32 = u32(0);
    for(;;)
    {
        if(axis_9 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_10, (*which_9) + axis_9, (bitcast<u32>((value_13[axis_9]))));
        axis_9 = axis_9 + u32(1);
    }
    (*which_9) = (*which_9) + u32(3);
    return;
}

fn set_place_0( path_11 : u32,  which_10 : ptr<function, u32>,  place_23 : Place_0)
{
    set_word_0(path_11, (*which_10), place_23.triangle_0);
    set_word_0(path_11, (*which_10) + u32(1), (bitcast<u32>((place_23.v_0))));
    set_word_0(path_11, (*which_10) + u32(2), (bitcast<u32>((place_23.w_0))));
    (*which_10) = (*which_10) + u32(3);
    return;
}

fn set_place_1( path_12 : u32,  which_11 : ptr<function, u32>,  place_24 : Place_0)
{
    set_word_0(path_12, (*which_11), place_24.triangle_0);
    set_word_0(path_12, (*which_11) + u32(1), (bitcast<u32>((place_24.v_0))));
    set_word_0(path_12, (*which_11) + u32(2), (bitcast<u32>((place_24.w_0))));
    (*which_11) = (*which_11) + u32(3);
    return;
}

fn set_changing_0( path_13 : u32,  which_12 : ptr<function, u32>,  vector_1 : vec3<f32>)
{
    set_vector_2(path_13, &((*which_12)), value_of_0(vector_1));
    return;
}

fn store_0( number_of_path_1 : u32,  path_14 : Path_0)
{
    var at_20 : u32 = u32(1);
    set_vector_0(number_of_path_1, &(at_20), path_14.adjoint_0);
    set_changing_0(number_of_path_1, &(at_20), path_14.throughput_0);
    set_changing_0(number_of_path_1, &(at_20), path_14.direction_0);
    set_place_0(number_of_path_1, &(at_20), path_14.place_3);
    set_word_0(number_of_path_1, at_20, path_14.key_0.x);
    set_word_0(number_of_path_1, at_20 + u32(1), path_14.key_0.y);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn go_on_reverse(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var at_21 : u32 = launch_0.first_0 + thread_0.x;
    if(at_21 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_2 : u32 = input_0[at_21];
    var path_15 : Path_0 = load_0(number_of_path_2);
    var importance_4 : vec3<f32> = path_15.adjoint_0 * path_15.throughput_0;
    var direction_25 : vec3<f32> = path_15.direction_0;
    var place_25 : Place_0 = path_15.place_3;
    var reflected_3 : Reflected_0 = nothing_reflected_0();
    var goes_on_2 : bool = take_further_0(&(path_15), &(reflected_3), importance_4);
    var material_3 : u32 = material_of_0(surface_at_0(place_25, direction_25));
    if(material_3 != u32(4294967295))
    {
        add_to_textures_0(material_3, place_25, reflected_3.by_emitters_0);
    }
    var kept_0 : u32 = kept_at_0();
    set_vector_1(number_of_path_2, &(kept_0), importance_4);
    set_place_1(number_of_path_2, &(kept_0), place_25);
    set_vector_1(number_of_path_2, &(kept_0), direction_25);
    set_vector_1(number_of_path_2, &(kept_0), reflected_3.direct_0);
    set_vector_1(number_of_path_2, &(kept_0), reflected_3.onward_0);
    set_vector_1(number_of_path_2, &(kept_0), reflected_3.wo_0);
    var _S1116 : u32 = kept_0;
    kept_0 = kept_0 + u32(1);
    var _S1117 : i32;
    if(reflected_3.is_specular_0)
    {
        _S1117 = i32(1);
    }
    else
    {
        _S1117 = i32(0);
    }
    set_word_0(number_of_path_2, _S1116, u32(_S1117));
    set_word_0(number_of_path_2, kept_0, (bitcast<u32>((reflected_3.factor_0))));
    path_15.throughput_0 = path_15.throughput_0 * reflected_3.onward_0;
    store_0(number_of_path_2, path_15);
    var _S1118 : u32;
    if(goes_on_2)
    {
        _S1118 = number_of_path_2;
    }
    else
    {
        _S1118 = u32(4294967295);
    }
    set_word_0(at_21, u32(0), _S1118);
    return;
}
