// Compiled from reverse.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 56d966057bf54911
// result: b7a195f17628b804

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

@binding(2) @group(0) var<storage, read> primitives_0 : array<f64>;

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
     value0_5 : vec2<f32>,
};

fn s_apply_max_0( x_6 : vec2<f32>,  y_1 : vec2<f32>) -> Tuple_3
{
    var _S39 : Tuple_3 = Tuple_3( max(x_6, y_1) );
    return _S39;
}

struct s_bwdCallableCtx_max_0
{
     _S40 : vec2<f32>,
     _S41 : vec2<f32>,
};

fn _d_max_0( dpx_2 : ptr<function, DiffPair_float_0>,  dpy_1 : ptr<function, DiffPair_float_0>,  dOut_2 : f32)
{
    var _S42 : DiffPair_float_0 = (*dpx_2);
    var _S43 : f32;
    if(((*dpx_2).primal_0) > ((*dpy_1).primal_0))
    {
        _S43 = dOut_2;
    }
    else
    {
        if(((*dpx_2).primal_0) < ((*dpy_1).primal_0))
        {
            _S43 = 0.0f;
        }
        else
        {
            _S43 = 0.5f * dOut_2;
        }
    }
    (*dpx_2).primal_0 = _S42.primal_0;
    (*dpx_2).differential_0 = _S43;
    var _S44 : DiffPair_float_0 = (*dpy_1);
    if(((*dpy_1).primal_0) > (_S42.primal_0))
    {
        _S43 = dOut_2;
    }
    else
    {
        if(((*dpy_1).primal_0) < ((*dpx_2).primal_0))
        {
            _S43 = 0.0f;
        }
        else
        {
            _S43 = 0.5f * dOut_2;
        }
    }
    (*dpy_1).primal_0 = _S44.primal_0;
    (*dpy_1).differential_0 = _S43;
    return;
}

fn _d_max_vector_0( dpx_3 : ptr<function, DiffPair_vectorx3Cfloatx2C2x3E_0>,  dpy_2 : ptr<function, DiffPair_vectorx3Cfloatx2C2x3E_0>,  dOut_3 : vec2<f32>)
{
    var left_dp_0 : DiffPair_float_0;
    left_dp_0.primal_0 = (*dpx_3).primal_0[i32(0)];
    left_dp_0.differential_0 = 0.0f;
    var right_dp_0 : DiffPair_float_0;
    right_dp_0.primal_0 = (*dpy_2).primal_0[i32(0)];
    right_dp_0.differential_0 = 0.0f;
    _d_max_0(&(left_dp_0), &(right_dp_0), dOut_3[i32(0)]);
    var left_d_result_0 : vec2<f32>;
    left_d_result_0[i32(0)] = left_dp_0.differential_0;
    var right_d_result_0 : vec2<f32>;
    right_d_result_0[i32(0)] = right_dp_0.differential_0;
    var left_dp_1 : DiffPair_float_0;
    left_dp_1.primal_0 = (*dpx_3).primal_0[i32(1)];
    left_dp_1.differential_0 = 0.0f;
    var right_dp_1 : DiffPair_float_0;
    right_dp_1.primal_0 = (*dpy_2).primal_0[i32(1)];
    right_dp_1.differential_0 = 0.0f;
    _d_max_0(&(left_dp_1), &(right_dp_1), dOut_3[i32(1)]);
    left_d_result_0[i32(1)] = left_dp_1.differential_0;
    right_d_result_0[i32(1)] = right_dp_1.differential_0;
    (*dpx_3).primal_0 = (*dpx_3).primal_0;
    (*dpx_3).differential_0 = left_d_result_0;
    (*dpy_2).primal_0 = (*dpy_2).primal_0;
    (*dpy_2).differential_0 = right_d_result_0;
    return;
}

fn s_bwdProp_max_0( ctx_4 : s_bwdCallableCtx_max_0,  d_x_4 : ptr<function, vec2<f32>>,  d_y_1 : ptr<function, vec2<f32>>,  d_out_4 : vec2<f32>)
{
    var _S45 : DiffPair_vectorx3Cfloatx2C2x3E_0;
    _S45.primal_0 = ctx_4._S40;
    var _S46 : DiffPair_vectorx3Cfloatx2C2x3E_0;
    _S46.primal_0 = ctx_4._S41;
    _d_max_vector_0(&(_S45), &(_S46), d_out_4);
    (*d_x_4) = _S45.differential_0;
    (*d_y_1) = _S46.differential_0;
    return;
}

struct Tuple_4
{
     value0_6 : f32,
};

fn s_apply_sqrt_0( x_7 : f32) -> Tuple_4
{
    var _S47 : Tuple_4 = Tuple_4( sqrt(x_7) );
    return _S47;
}

struct s_bwdCallableCtx_cross_0
{
     _S48 : vec3<f32>,
     _S49 : vec3<f32>,
};

fn _d_cross_0( a_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  b_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dOut_4 : vec3<f32>)
{
    var _S50 : f32 = dOut_4.y;
    var _S51 : f32 = dOut_4.z;
    var _S52 : f32 = dOut_4.x;
    var _S53 : f32 = (*a_0).primal_0.z * _S50 + - (*a_0).primal_0.y * _S51;
    var _S54 : f32 = - (*a_0).primal_0.z * _S52 + (*a_0).primal_0.x * _S51;
    var _S55 : f32 = (*a_0).primal_0.y * _S52 + - (*a_0).primal_0.x * _S50;
    var _S56 : vec3<f32> = vec3<f32>(- (*b_0).primal_0.z * _S50 + (*b_0).primal_0.y * _S51, (*b_0).primal_0.z * _S52 + - (*b_0).primal_0.x * _S51, - (*b_0).primal_0.y * _S52 + (*b_0).primal_0.x * _S50);
    (*a_0).primal_0 = (*a_0).primal_0;
    (*a_0).differential_0 = _S56;
    var _S57 : vec3<f32> = vec3<f32>(_S53, _S54, _S55);
    (*b_0).primal_0 = (*b_0).primal_0;
    (*b_0).differential_0 = _S57;
    return;
}

fn s_bwdProp_cross_0( ctx_5 : s_bwdCallableCtx_cross_0,  d_left_0 : ptr<function, vec3<f32>>,  d_right_0 : ptr<function, vec3<f32>>,  d_out_5 : vec3<f32>)
{
    var _S58 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S58.primal_0 = ctx_5._S48;
    var _S59 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S59.primal_0 = ctx_5._S49;
    _d_cross_0(&(_S58), &(_S59), d_out_5);
    (*d_left_0) = _S58.differential_0;
    (*d_right_0) = _S59.differential_0;
    return;
}

struct Tuple_5
{
     value0_7 : vec3<f32>,
};

fn s_apply_normalize_0( x_8 : vec3<f32>) -> Tuple_5
{
    var _S60 : Tuple_5 = Tuple_5( normalize(x_8) );
    return _S60;
}

struct s_bwdCallableCtx_normalize_0
{
     _S61 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_normalize_impl_0
{
     value0_8 : vec3<f32>,
};

struct s_bwdCallableCtx_normalize_impl_0
{
     value0_9 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0,
};

fn s_bwdProp_normalize_impl_0( _S62 : s_bwdCallableCtx_normalize_impl_0,  _S63 : ptr<function, vec3<f32>>,  _S64 : vec3<f32>)
{
    var _S65 : Tuple_0 = s_apply_length_0(_S62.value0_9.value0_8);
    var _S66 : s_bwdCallableCtx_length_0;
    _S66._S2 = _S62.value0_9.value0_8;
    var _S67 : vec3<f32> = _S62.value0_9.value0_8 * _S64;
    var _S68 : vec3<f32> = vec3<f32>((1.0f / _S65.value0_0)) * _S64;
    var _S69 : f32 = - ((_S67[i32(0)] + _S67[i32(1)] + _S67[i32(2)]) / (_S65.value0_0 * _S65.value0_0));
    var _S70 : vec3<f32> = vec3<f32>(0.0f);
    s_bwdProp_length_0(_S66, &(_S70), _S69);
    (*_S63) = _S68 + _S70;
    return;
}

fn _S71( _S72 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S73 : vec3<f32>)
{
    var _S74 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0;
    _S74.value0_8 = (*_S72).primal_0;
    var _S75 : s_bwdCallableCtx_normalize_impl_0 = s_bwdCallableCtx_normalize_impl_0( _S74 );
    var _S76 : vec3<f32> = (*_S72).differential_0;
    s_bwdProp_normalize_impl_0(_S75, &(_S76), _S73);
    (*_S72).differential_0 = _S76;
    return;
}

fn s_bwdProp_normalize_0( ctx_6 : s_bwdCallableCtx_normalize_0,  d_x_5 : ptr<function, vec3<f32>>,  d_out_6 : vec3<f32>)
{
    var _S77 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S77.primal_0 = ctx_6._S61;
    _S71(&(_S77), d_out_6);
    (*d_x_5) = _S77.differential_0;
    return;
}

struct Tuple_6
{
     value0_10 : f32,
};

fn s_apply_dot_1( x_9 : vec3<f32>,  y_2 : vec3<f32>) -> Tuple_6
{
    var _S78 : Tuple_6 = Tuple_6( dot(x_9, y_2) );
    return _S78;
}

struct s_bwdCallableCtx_dot_1
{
     _S79 : vec3<f32>,
     _S80 : vec3<f32>,
};

fn _d_dot_1( dpx_4 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dpy_3 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dOut_5 : f32)
{
    var x_d_result_1 : vec3<f32>;
    x_d_result_1[i32(0)] = (*dpy_3).primal_0[i32(0)] * dOut_5;
    var y_d_result_1 : vec3<f32>;
    y_d_result_1[i32(0)] = (*dpx_4).primal_0[i32(0)] * dOut_5;
    x_d_result_1[i32(1)] = (*dpy_3).primal_0[i32(1)] * dOut_5;
    y_d_result_1[i32(1)] = (*dpx_4).primal_0[i32(1)] * dOut_5;
    x_d_result_1[i32(2)] = (*dpy_3).primal_0[i32(2)] * dOut_5;
    y_d_result_1[i32(2)] = (*dpx_4).primal_0[i32(2)] * dOut_5;
    (*dpx_4).primal_0 = (*dpx_4).primal_0;
    (*dpx_4).differential_0 = x_d_result_1;
    (*dpy_3).primal_0 = (*dpy_3).primal_0;
    (*dpy_3).differential_0 = y_d_result_1;
    return;
}

fn s_bwdProp_dot_1( ctx_7 : s_bwdCallableCtx_dot_1,  d_x_6 : ptr<function, vec3<f32>>,  d_y_2 : ptr<function, vec3<f32>>,  d_out_7 : f32)
{
    var _S81 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S81.primal_0 = ctx_7._S79;
    var _S82 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S82.primal_0 = ctx_7._S80;
    _d_dot_1(&(_S81), &(_S82), d_out_7);
    (*d_x_6) = _S81.differential_0;
    (*d_y_2) = _S82.differential_0;
    return;
}

struct s_bwdCallableCtx_max_1
{
     _S83 : f32,
     _S84 : f32,
};

fn s_bwdProp_max_1( ctx_8 : s_bwdCallableCtx_max_1,  d_x_7 : ptr<function, f32>,  d_y_3 : ptr<function, f32>,  d_out_8 : f32)
{
    var _S85 : DiffPair_float_0;
    _S85.primal_0 = ctx_8._S83;
    var _S86 : DiffPair_float_0;
    _S86.primal_0 = ctx_8._S84;
    _d_max_0(&(_S85), &(_S86), d_out_8);
    (*d_x_7) = _S85.differential_0;
    (*d_y_3) = _S86.differential_0;
    return;
}

struct Tuple_7
{
     value0_11 : f32,
};

fn s_apply_abs_0( x_10 : f32) -> Tuple_7
{
    var _S87 : Tuple_7 = Tuple_7( abs(x_10) );
    return _S87;
}

struct s_bwdCallableCtx_abs_0
{
     _S88 : f32,
};

fn _d_abs_0( dpx_5 : ptr<function, DiffPair_float_0>,  dOut_6 : f32)
{
    var _S89 : f32 = select(select(-1.0f, 0.0f, ((*dpx_5).primal_0) == 0.0f), 1.0f, ((*dpx_5).primal_0) > 0.0f) * dOut_6;
    (*dpx_5).primal_0 = (*dpx_5).primal_0;
    (*dpx_5).differential_0 = _S89;
    return;
}

fn s_bwdProp_abs_0( ctx_9 : s_bwdCallableCtx_abs_0,  d_x_8 : ptr<function, f32>,  d_out_9 : f32)
{
    var _S90 : DiffPair_float_0;
    _S90.primal_0 = ctx_9._S88;
    _d_abs_0(&(_S90), d_out_9);
    (*d_x_8) = _S90.differential_0;
    return;
}

struct Axes_0
{
     s_0 : vec3<f32>,
     t_0 : vec3<f32>,
     n_0 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_axes_around_0
{
     value0_12 : vec3<f32>,
     value1_0 : bool,
};

struct s_bwdCallableCtx_axes_around_0
{
     value0_13 : s_paramCtx_s_bwdCallableCtx_axes_around_0,
};

fn s_bwdProp_axes_around_0( _S91 : s_bwdCallableCtx_axes_around_0,  _S92 : ptr<function, vec3<f32>>,  _S93 : Axes_0)
{
    var _S94 : f32 = _S91.value0_13.value0_12.z;
    var sign_0 : f32;
    if(_S94 < -0.00000999999974738f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var _S95 : f32 = sign_0 + _S94;
    var a_1 : f32 = -1.0f / _S95;
    var _S96 : f32 = _S95 * _S95;
    var _S97 : f32 = _S91.value0_13.value0_12.x;
    var _S98 : f32 = _S91.value0_13.value0_12.y;
    var _S99 : f32 = _S97 * _S98;
    var _S100 : f32 = sign_0 * _S97;
    var _S101 : f32 = _S100 * _S97;
    var _S102 : f32 = - sign_0;
    var _S103 : f32 = _S98 * _S98;
    var _S104 : f32 = _S98 * (a_1 * _S93.t_0[i32(1)]);
    var _S105 : f32 = a_1 * _S93.s_0[i32(0)];
    var _S106 : f32 = _S93.t_0[i32(0)] + sign_0 * _S93.s_0[i32(1)];
    var _S107 : f32 = a_1 * _S106;
    var _S108 : vec3<f32> = vec3<f32>(_S102 * _S93.s_0[i32(2)] + _S100 * _S105 + sign_0 * (_S97 * _S105) + _S98 * _S107, - _S93.t_0[i32(2)] + _S104 + _S104 + _S97 * _S107, 0.0f) + vec3<f32>(0.0f, 0.0f, -1.0f * - ((_S103 * _S93.t_0[i32(1)] + _S101 * _S93.s_0[i32(0)] + _S99 * _S106) / _S96));
    var _S109 : vec3<f32>;
    if(_S91.value0_13.value1_0)
    {
        _S109 = _S93.n_0 + _S108;
    }
    else
    {
        _S109 = (vec3<f32>(0) - _S93.n_0) + _S108;
    }
    (*_S92) = _S109;
    return;
}

fn _S110( _S111 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S112 : bool,  _S113 : Axes_0)
{
    var _S114 : s_paramCtx_s_bwdCallableCtx_axes_around_0;
    _S114.value0_12 = (*_S111).primal_0;
    _S114.value1_0 = _S112;
    var _S115 : s_bwdCallableCtx_axes_around_0 = s_bwdCallableCtx_axes_around_0( _S114 );
    var _S116 : vec3<f32> = (*_S111).differential_0;
    s_bwdProp_axes_around_0(_S115, &(_S116), _S113);
    (*_S111).differential_0 = _S116;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_axes_along_0
{
     value0_14 : vec3<f32>,
     value1_1 : vec3<f32>,
     value2_0 : bool,
};

struct s_bwdCallableCtx_axes_along_0
{
     value0_15 : s_paramCtx_s_bwdCallableCtx_axes_along_0,
};

fn s_bwdProp_axes_along_0( _S117 : s_bwdCallableCtx_axes_along_0,  _S118 : ptr<function, vec3<f32>>,  _S119 : ptr<function, vec3<f32>>,  _S120 : Axes_0)
{
    var _S121 : vec3<f32> = vec3<f32>(s_apply_dot_1(_S117.value0_15.value0_14, _S117.value0_15.value1_1).value0_10);
    var _S122 : s_bwdCallableCtx_dot_1;
    _S122._S79 = _S117.value0_15.value0_14;
    _S122._S80 = _S117.value0_15.value1_1;
    var _S123 : vec3<f32> = _S117.value0_15.value1_1 - _S117.value0_15.value0_14 * _S121;
    var _S124 : Tuple_5 = s_apply_normalize_0(_S123);
    var _S125 : s_bwdCallableCtx_normalize_0;
    _S125._S61 = _S123;
    var _S126 : s_bwdCallableCtx_cross_0;
    _S126._S48 = _S117.value0_15.value0_14;
    _S126._S49 = _S124.value0_7;
    var _S127 : vec3<f32> = vec3<f32>(0.0f);
    var _S128 : vec3<f32> = _S127;
    var _S129 : vec3<f32> = _S127;
    s_bwdProp_cross_0(_S126, &(_S128), &(_S129), _S120.t_0);
    var _S130 : vec3<f32> = _S120.s_0 + _S129;
    var _S131 : vec3<f32> = _S127;
    s_bwdProp_normalize_0(_S125, &(_S131), _S130);
    var _S132 : vec3<f32> = (vec3<f32>(0) - _S131);
    var _S133 : vec3<f32> = _S117.value0_15.value0_14 * _S132;
    var _S134 : vec3<f32> = _S121 * _S132;
    var _S135 : f32 = _S133[i32(0)] + _S133[i32(1)] + _S133[i32(2)];
    var _S136 : vec3<f32> = _S127;
    var _S137 : vec3<f32> = _S127;
    s_bwdProp_dot_1(_S122, &(_S136), &(_S137), _S135);
    var _S138 : vec3<f32> = _S128 + _S134 + _S136;
    var _S139 : vec3<f32> = _S131 + _S137;
    var _S140 : vec3<f32>;
    if(_S117.value0_15.value2_0)
    {
        _S140 = _S120.n_0 + _S138;
    }
    else
    {
        _S140 = (vec3<f32>(0) - _S120.n_0) + _S138;
    }
    (*_S118) = _S140;
    (*_S119) = _S139;
    return;
}

fn _S141( _S142 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S143 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S144 : bool,  _S145 : Axes_0)
{
    var _S146 : s_paramCtx_s_bwdCallableCtx_axes_along_0;
    _S146.value0_14 = (*_S142).primal_0;
    _S146.value1_1 = (*_S143).primal_0;
    _S146.value2_0 = _S144;
    var _S147 : s_bwdCallableCtx_axes_along_0 = s_bwdCallableCtx_axes_along_0( _S146 );
    var _S148 : vec3<f32> = (*_S142).differential_0;
    var _S149 : vec3<f32> = (*_S143).differential_0;
    s_bwdProp_axes_along_0(_S147, &(_S148), &(_S149), _S145);
    (*_S142).differential_0 = _S148;
    (*_S143).differential_0 = _S149;
    return;
}

struct DiffPair_Axes_0
{
     primal_0 : Axes_0,
     differential_0 : Axes_0,
};

struct s_paramCtx_s_bwdCallableCtx_towards_viewer_0
{
     value0_16 : Axes_0,
     value1_2 : vec3<f32>,
};

struct s_bwdCallableCtx_towards_viewer_0
{
     value0_17 : s_paramCtx_s_bwdCallableCtx_towards_viewer_0,
};

struct Tuple_8
{
     value0_18 : vec3<f32>,
};

fn s_apply_to_local_0( _S150 : Axes_0,  _S151 : vec3<f32>) -> Tuple_8
{
    var _S152 : Tuple_8;
    _S152.value0_18 = vec3<f32>(s_apply_dot_1(_S150.s_0, _S151).value0_10, s_apply_dot_1(_S150.t_0, _S151).value0_10, s_apply_dot_1(_S150.n_0, _S151).value0_10);
    return _S152;
}

struct s_paramCtx_s_bwdCallableCtx_to_local_0
{
     value0_19 : Axes_0,
     value1_3 : vec3<f32>,
};

struct s_bwdCallableCtx_to_local_0
{
     value0_20 : s_paramCtx_s_bwdCallableCtx_to_local_0,
};

fn Axes_x24_syn_dzero_0() -> Axes_0
{
    var result_0 : Axes_0;
    var _S153 : vec3<f32> = vec3<f32>(0.0f);
    result_0.s_0 = _S153;
    result_0.t_0 = _S153;
    result_0.n_0 = _S153;
    return result_0;
}

fn Axes_x24_syn_dadd_0( SLANG_anonymous_0_0 : Axes_0,  SLANG_anonymous_1_0 : Axes_0) -> Axes_0
{
    var result_1 : Axes_0;
    result_1.s_0 = SLANG_anonymous_0_0.s_0 + SLANG_anonymous_1_0.s_0;
    result_1.t_0 = SLANG_anonymous_0_0.t_0 + SLANG_anonymous_1_0.t_0;
    result_1.n_0 = SLANG_anonymous_0_0.n_0 + SLANG_anonymous_1_0.n_0;
    return result_1;
}

fn s_bwdProp_to_local_0( _S154 : s_bwdCallableCtx_to_local_0,  _S155 : ptr<function, Axes_0>,  _S156 : ptr<function, vec3<f32>>,  _S157 : vec3<f32>)
{
    var _S158 : s_bwdCallableCtx_dot_1;
    _S158._S79 = _S154.value0_20.value0_19.s_0;
    _S158._S80 = _S154.value0_20.value1_3;
    var _S159 : s_bwdCallableCtx_dot_1;
    _S159._S79 = _S154.value0_20.value0_19.t_0;
    _S159._S80 = _S154.value0_20.value1_3;
    var _S160 : s_bwdCallableCtx_dot_1;
    _S160._S79 = _S154.value0_20.value0_19.n_0;
    _S160._S80 = _S154.value0_20.value1_3;
    var _S161 : Axes_0 = Axes_x24_syn_dzero_0();
    var _S162 : vec3<f32> = vec3<f32>(0.0f);
    var _S163 : vec3<f32> = _S162;
    var _S164 : vec3<f32> = _S162;
    s_bwdProp_dot_1(_S160, &(_S163), &(_S164), _S157[i32(2)]);
    var _S165 : vec3<f32> = _S162;
    var _S166 : vec3<f32> = _S162;
    s_bwdProp_dot_1(_S159, &(_S165), &(_S166), _S157[i32(1)]);
    var _S167 : vec3<f32> = _S162;
    var _S168 : vec3<f32> = _S162;
    s_bwdProp_dot_1(_S158, &(_S167), &(_S168), _S157[i32(0)]);
    var _S169 : vec3<f32> = _S164 + _S166 + _S168;
    var _S170 : Axes_0 = _S161;
    _S170.n_0 = _S163;
    _S170.t_0 = _S165;
    _S170.s_0 = _S167;
    (*_S155) = Axes_x24_syn_dadd_0(_S161, _S170);
    (*_S156) = _S169;
    return;
}

fn s_bwdProp_towards_viewer_0( _S171 : s_bwdCallableCtx_towards_viewer_0,  _S172 : ptr<function, Axes_0>,  _S173 : ptr<function, vec3<f32>>,  _S174 : vec3<f32>)
{
    var _S175 : Tuple_8 = s_apply_to_local_0(_S171.value0_17.value0_16, _S171.value0_17.value1_2);
    var _S176 : s_paramCtx_s_bwdCallableCtx_to_local_0;
    _S176.value0_19 = _S171.value0_17.value0_16;
    _S176.value1_3 = _S171.value0_17.value1_2;
    var _S177 : s_bwdCallableCtx_to_local_0 = s_bwdCallableCtx_to_local_0( _S176 );
    var _S178 : f32 = (vec3<f32>(0) - _S175.value0_18).z;
    var _S179 : Tuple_7 = s_apply_abs_0(_S178);
    var _S180 : s_bwdCallableCtx_abs_0;
    _S180._S88 = _S178;
    var _S181 : s_bwdCallableCtx_max_1;
    _S181._S83 = _S179.value0_11;
    _S181._S84 = 9.999999960041972e-13f;
    var _S182 : Axes_0 = Axes_x24_syn_dzero_0();
    var _S183 : f32 = 0.0f;
    var _S184 : f32 = 0.0f;
    s_bwdProp_max_1(_S181, &(_S183), &(_S184), _S174[i32(2)]);
    var _S185 : f32 = 0.0f;
    s_bwdProp_abs_0(_S180, &(_S185), _S183);
    var _S186 : vec3<f32> = (vec3<f32>(0) - vec3<f32>(_S174[i32(0)], _S174[i32(1)], _S185));
    var _S187 : vec3<f32> = vec3<f32>(0.0f);
    var _S188 : Axes_0;
    _S188.s_0 = _S187;
    _S188.t_0 = _S187;
    _S188.n_0 = _S187;
    var _S189 : vec3<f32> = _S187;
    s_bwdProp_to_local_0(_S177, &(_S188), &(_S189), _S186);
    (*_S172) = Axes_x24_syn_dadd_0(_S188, _S182);
    (*_S173) = _S189;
    return;
}

fn _S190( _S191 : ptr<function, DiffPair_Axes_0>,  _S192 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S193 : vec3<f32>)
{
    var _S194 : s_paramCtx_s_bwdCallableCtx_towards_viewer_0;
    _S194.value0_16 = (*_S191).primal_0;
    _S194.value1_2 = (*_S192).primal_0;
    var _S195 : s_bwdCallableCtx_towards_viewer_0 = s_bwdCallableCtx_towards_viewer_0( _S194 );
    var _S196 : Axes_0 = (*_S191).differential_0;
    var _S197 : vec3<f32> = (*_S192).differential_0;
    s_bwdProp_towards_viewer_0(_S195, &(_S196), &(_S197), _S193);
    (*_S191).differential_0 = _S196;
    (*_S192).differential_0 = _S197;
    return;
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
     value0_21 : f32,
     value1_4 : f32,
};

struct s_minCtx_s_bwdCallableCtx_base_0
{
     value0_22 : f32,
     value1_5 : u32,
};

struct s_minCtx_s_bwdCallableCtx_scattering_0
{
     value0_23 : f32,
     value1_6 : s_minCtx_s_bwdCallableCtx_transmittance_0,
     value2_1 : f32,
     value3_0 : s_minCtx_s_bwdCallableCtx_transmittance_0,
     value4_0 : vec3<f32>,
     value5_0 : s_minCtx_s_bwdCallableCtx_base_0,
};

struct Tuple_9
{
     value0_24 : Scattering_0,
     value1_7 : s_minCtx_s_bwdCallableCtx_scattering_0,
};

struct Mirrored_0
{
     cosine_0 : f32,
     pdf_1 : f32,
     scattered_0 : f32,
};

struct Tuple_10
{
     value0_25 : Mirrored_0,
};

fn s_apply_Mirrored_x24init_0( _S198 : f32,  _S199 : f32,  _S200 : f32) -> Tuple_10
{
    var _S201 : Tuple_10;
    _S201.value0_25.cosine_0 = _S198;
    _S201.value0_25.pdf_1 = _S199;
    _S201.value0_25.scattered_0 = _S200;
    return _S201;
}

fn is_rough_0( lobe_0 : Lobe_0) -> bool
{
    var _S202 : bool;
    if((lobe_0.kind_0) == u32(2))
    {
        _S202 = true;
    }
    else
    {
        _S202 = (lobe_0.kind_0) == u32(4);
    }
    return _S202;
}

struct Microfacets_0
{
     distribution_1 : u32,
     alpha_1 : vec2<f32>,
};

struct Tuple_11
{
     value0_26 : Microfacets_0,
};

fn s_apply_facets_of_0( lobe_1 : Lobe_0,  _S203 : Numbers_0) -> Tuple_11
{
    var _S204 : Tuple_3 = s_apply_max_0(_S203.alpha_0, vec2<f32>(0.00009999999747379f));
    var _S205 : Tuple_11;
    _S205.value0_26.distribution_1 = lobe_1.distribution_0;
    _S205.value0_26.alpha_1 = _S204.value0_5;
    return _S205;
}

struct Tuple_12
{
     value0_27 : Mirrored_0,
};

struct Tuple_13
{
     value0_28 : f32,
};

struct Tuple_14
{
     value0_29 : f32,
};

fn s_apply_exponential_0( _S206 : f32) -> Tuple_14
{
    var _S207 : f32;
    if(!(_S206 < -87.0f))
    {
        var power_1 : f32 = floor(_S206 * 1.4426950216293335f + 0.5f);
        var r_1 : f32 = _S206 - power_1 * 0.693359375f + power_1 * 0.00021219444170129f;
        _S207 = ((((((0.00019875691214111f * r_1 + 0.00139819993637502f) * r_1 + 0.00833345204591751f) * r_1 + 0.04166579619050026f) * r_1 + 0.1666666567325592f) * r_1 + 0.5f) * r_1 * r_1 + r_1 + 1.0f) * (bitcast<f32>(((u32(i32(power_1) + i32(127)) << (u32(23))))));
    }
    else
    {
        _S207 = 0.0f;
    }
    var _S208 : Tuple_14;
    _S208.value0_29 = _S207;
    return _S208;
}

fn s_apply_density_0( _S209 : Microfacets_0,  _S210 : vec3<f32>) -> Tuple_13
{
    var _S211 : f32 = _S210.z;
    var _S212 : bool = !(_S211 <= 0.0f);
    var _S213 : f32;
    if(_S212)
    {
        var scale_0 : f32 = 3.14159274101257324f * _S209.alpha_1.x * _S209.alpha_1.y;
        var slope_1 : vec2<f32> = _S210.xy / _S209.alpha_1;
        var _S214 : Tuple_2 = s_apply_dot_0(slope_1, slope_1);
        var cos2_0 : f32 = _S211 * _S211;
        var _runFlag_0 : bool;
        if((_S209.distribution_1) == u32(1))
        {
            var sum_0 : f32 = _S214.value0_4 + cos2_0;
            var _S215 : f32 = 1.0f / (scale_0 * sum_0 * sum_0);
            _runFlag_0 = false;
            _S213 = _S215;
        }
        else
        {
            _runFlag_0 = _S212;
            _S213 = 0.0f;
        }
        if(_runFlag_0)
        {
            var exponent_0 : f32 = _S214.value0_4 / cos2_0;
            if(exponent_0 > 80.0f)
            {
                _S213 = 0.0f;
            }
            else
            {
                _S213 = s_apply_exponential_0(- exponent_0).value0_29 / (scale_0 * cos2_0 * cos2_0);
            }
        }
    }
    else
    {
        _S213 = 0.0f;
    }
    var _S216 : Tuple_13;
    _S216.value0_28 = _S213;
    return _S216;
}

struct Tuple_15
{
     value0_30 : f32,
};

fn s_apply_visible_over_cos_0( _S217 : Microfacets_0,  _S218 : vec3<f32>) -> Tuple_15
{
    var stretched_0 : vec2<f32> = _S218.xy * _S217.alpha_1;
    var _S219 : Tuple_2 = s_apply_dot_0(stretched_0, stretched_0);
    var _S220 : f32 = _S218.z;
    var z2_0 : f32 = _S220 * _S220;
    var _S221 : bool = (_S217.distribution_1) == u32(1);
    var _S222 : f32;
    if(_S221)
    {
        _S222 = 2.0f / (_S220 + s_apply_sqrt_0(z2_0 + _S219.value0_4).value0_6);
    }
    var _S223 : bool = !_S221;
    if(_S223)
    {
        var _runFlag_1 : bool;
        if(z2_0 >= (36.0f * _S219.value0_4))
        {
            var _S224 : f32 = 1.0f / _S220;
            _runFlag_1 = false;
            _S222 = _S224;
        }
        else
        {
            _runFlag_1 = _S223;
        }
        if(_runFlag_1)
        {
            var _S225 : Tuple_4 = s_apply_sqrt_0(_S219.value0_4);
            var _S226 : Tuple_1 = s_apply_error_function_plus_one_0(_S220 / _S225.value0_6);
            _S222 = 2.0f / (_S220 * _S226.value0_3.x + 0.5f * _S225.value0_6 * _S226.value0_3.y);
        }
    }
    var _S227 : Tuple_15;
    _S227.value0_30 = _S222;
    return _S227;
}

fn s_apply_mirrored_0( _S228 : Microfacets_0,  _S229 : vec3<f32>,  _S230 : vec3<f32>) -> Tuple_12
{
    var _S231 : Tuple_5 = s_apply_normalize_0(_S229 + _S230);
    var _S232 : f32 = 0.25f * s_apply_density_0(_S228, _S231.value0_7).value0_28 * s_apply_visible_over_cos_0(_S228, _S229).value0_30;
    var _S233 : f32 = _S232 * s_apply_visible_over_cos_0(_S228, _S230).value0_30 * _S230.z;
    var _S234 : Tuple_12;
    _S234.value0_27.cosine_0 = s_apply_dot_1(_S229, _S231.value0_7).value0_10;
    _S234.value0_27.pdf_1 = _S232;
    _S234.value0_27.scattered_0 = _S233;
    return _S234;
}

struct Tuple_16
{
     value0_31 : vec3<f32>,
};

struct Tuple_17
{
     value0_32 : f32,
};

fn s_apply_fresnel_conductor_channel_0( _S235 : f32,  _S236 : f32,  _S237 : f32) -> Tuple_17
{
    var cos2_1 : f32 = _S235 * _S235;
    var sin2_0 : f32 = 1.0f - cos2_1;
    var real_0 : f32 = _S236 * _S236 - _S237 * _S237 - sin2_0;
    var product_0 : f32 = _S236 * _S237;
    var _S238 : Tuple_4 = s_apply_sqrt_0(real_0 * real_0 + 4.0f * (product_0 * product_0));
    var a_2 : f32;
    if(!((_S238.value0_6) == 0.0f))
    {
        var _S239 : Tuple_4 = s_apply_sqrt_0(0.5f * (_S238.value0_6 + s_apply_abs_0(real_0).value0_11));
        var smaller_0 : f32 = product_0 / _S239.value0_6;
        var _S240 : bool = real_0 < 0.0f;
        if(_S240)
        {
            a_2 = smaller_0;
        }
        else
        {
            a_2 = _S239.value0_6;
        }
        var b_1 : f32;
        if(_S240)
        {
            b_1 = _S239.value0_6;
        }
        else
        {
            b_1 = smaller_0;
        }
        var less_0 : f32 = a_2 - _S235;
        var more_0 : f32 = a_2 + _S235;
        var _S241 : f32 = b_1 * b_1;
        var p_sum_0 : f32 = _S238.value0_6 * cos2_1 + sin2_0 * sin2_0;
        a_2 = (less_0 * less_0 + _S241) / (more_0 * more_0 + _S241) * p_sum_0 / (p_sum_0 + 2.0f * a_2 * _S235 * sin2_0);
    }
    else
    {
        a_2 = 1.0f;
    }
    var _S242 : Tuple_17;
    _S242.value0_32 = a_2;
    return _S242;
}

fn s_apply_fresnel_conductor_0( _S243 : f32,  _S244 : vec3<f32>,  _S245 : vec3<f32>) -> Tuple_16
{
    var _S246 : Tuple_16;
    _S246.value0_31 = vec3<f32>(s_apply_fresnel_conductor_channel_0(_S243, _S244.x, _S245.x).value0_32, s_apply_fresnel_conductor_channel_0(_S243, _S244.y, _S245.y).value0_32, s_apply_fresnel_conductor_channel_0(_S243, _S244.z, _S245.z).value0_32);
    return _S246;
}

struct Tuple_18
{
     value0_33 : f32,
};

struct Tuple_19
{
     value0_34 : f32,
};

fn s_apply_luminance_0( _S247 : vec3<f32>) -> Tuple_19
{
    var _S248 : Tuple_19;
    _S248.value0_34 = s_apply_dot_1(_S247, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f)).value0_10;
    return _S248;
}

fn s_apply_coat_eta_0( _S249 : Numbers_0) -> Tuple_18
{
    var _S250 : Tuple_18;
    _S250.value0_33 = s_apply_luminance_0(_S249.eta_0).value0_34 / s_apply_luminance_0(_S249.k_0).value0_34;
    return _S250;
}

struct Tuple_20
{
     value0_35 : f32,
     value1_8 : s_minCtx_s_bwdCallableCtx_transmittance_0,
};

struct Tuple_21
{
     value0_36 : f32,
};

fn s_apply_fresnel_dielectric_0( _S251 : f32,  _S252 : f32) -> Tuple_21
{
    var eta2_0 : f32 = _S252 * _S252;
    var cos2_2 : f32 = _S251 * _S251;
    var denser_0 : f32 = (_S252 - 1.0f) * (_S252 + 1.0f);
    var squared_0 : f32 = denser_0 + cos2_2;
    var _S253 : f32;
    if(!(squared_0 <= 0.0f))
    {
        var _S254 : Tuple_4 = s_apply_sqrt_0(squared_0);
        var s_sum_0 : f32 = _S251 + _S254.value0_6;
        var p_sum_1 : f32 = eta2_0 * _S251 + _S254.value0_6;
        var senkrecht_0 : f32 = denser_0 / (s_sum_0 * s_sum_0);
        var parallel_0 : f32 = denser_0 * ((eta2_0 + 1.0f) * cos2_2 - 1.0f) / (p_sum_1 * p_sum_1);
        _S253 = 0.5f * (senkrecht_0 * senkrecht_0 + parallel_0 * parallel_0);
    }
    else
    {
        _S253 = 1.0f;
    }
    var _S255 : Tuple_21;
    _S255.value0_36 = _S253;
    return _S255;
}

fn word_0( at_0 : u32) -> u32
{
    return scene_0[at_0];
}

fn number_0( at_1 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_1])));
}

fn s_apply_transmittance_0( lobe_2 : Lobe_0,  _S256 : f32,  _S257 : f32) -> Tuple_20
{
    var _S258 : s_minCtx_s_bwdCallableCtx_transmittance_0;
    _S258.value0_21 = 0.0f;
    _S258.value1_4 = 0.0f;
    var _S259 : bool = (lobe_2.kind_0) == u32(3);
    var _S260 : f32;
    if(_S259)
    {
        _S260 = 1.0f - s_apply_fresnel_dielectric_0(_S257, _S256).value0_36;
    }
    var _S261 : bool = !_S259;
    if(_S261)
    {
        var place_1 : f32 = _S257 * 63.0f;
        var _S262 : u32 = min(u32(place_1), u32(62));
        var at_2 : u32 = word_0(lobe_2.record_0 + u32(3)) + _S262;
        var here_0 : f32 = number_0(at_2);
        _S258.value0_21 = here_0;
        var next_0 : f32 = number_0(at_2 + u32(1));
        _S258.value1_4 = next_0;
        _S260 = here_0 + (next_0 - here_0) * (place_1 - f32(_S262));
    }
    var _S263 : Tuple_20;
    _S263.value0_35 = _S260;
    _S263.value1_8 = _S258;
    return _S263;
}

struct Tuple_22
{
     value0_37 : vec3<f32>,
     value1_9 : s_minCtx_s_bwdCallableCtx_base_0,
};

struct Tuple_23
{
     value0_38 : f32,
};

fn s_apply_fresnel_diffuse_0( _S264 : f32) -> Tuple_23
{
    var inverse_0 : f32 = 1.0f / _S264;
    var _S265 : bool = _S264 < 1.0f;
    var _S266 : f32;
    if(_S265)
    {
        _S266 = (-1.43990004062652588f * _S264 + 0.70990002155303955f) * _S264 + 0.66809999942779541f + 0.06360000371932983f * inverse_0;
    }
    var _S267 : bool = !_S265;
    if(_S267)
    {
        _S266 = ((((-1.36881005764007568f * inverse_0 + 4.98553991317749023f) * inverse_0 - 7.80988979339599609f) * inverse_0 + 6.75334978103637695f) * inverse_0 - 3.47930002212524414f) * inverse_0 + 0.91931700706481934f;
    }
    var _S268 : Tuple_23;
    _S268.value0_38 = _S266;
    return _S268;
}

fn s_apply_base_0( lobe_3 : Lobe_0,  _S269 : f32,  _S270 : vec3<f32>) -> Tuple_22
{
    var _S271 : s_minCtx_s_bwdCallableCtx_base_0;
    _S271.value0_22 = 0.0f;
    _S271.value1_5 = u32(0);
    var internal_reflectance_0 : f32;
    if((lobe_3.kind_0) == u32(3))
    {
        internal_reflectance_0 = s_apply_fresnel_diffuse_0(1.0f / _S269).value0_38;
    }
    else
    {
        var _S272 : f32 = number_0(word_0(lobe_3.record_0 + u32(3)) + u32(64));
        _S271.value0_22 = _S272;
        internal_reflectance_0 = _S272;
    }
    var _S273 : u32 = word_0(lobe_3.record_0 + u32(2));
    _S271.value1_5 = _S273;
    var _S274 : bool = _S273 == u32(0);
    var _S275 : vec3<f32>;
    if(_S274)
    {
        _S275 = _S270 * vec3<f32>((1.0f / (1.0f - internal_reflectance_0)));
    }
    var _S276 : bool = !_S274;
    if(_S276)
    {
        _S275 = _S270 / (vec3<f32>(1.0f) - _S270 * vec3<f32>(internal_reflectance_0));
    }
    var _S277 : Tuple_22;
    _S277.value0_37 = _S275;
    _S277.value1_9 = _S271;
    return _S277;
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

fn s_apply_scattering_0( lobe_4 : Lobe_0,  _S278 : Numbers_0,  _S279 : vec3<f32>,  _S280 : vec3<f32>) -> Tuple_9
{
    var _S281 : s_minCtx_s_bwdCallableCtx_transmittance_0 = s_minCtx_s_bwdCallableCtx_transmittance_0( 0.0f, 0.0f );
    var _S282 : vec3<f32> = vec3<f32>(0.0f);
    var _S283 : s_minCtx_s_bwdCallableCtx_base_0 = s_minCtx_s_bwdCallableCtx_base_0( 0.0f, u32(0) );
    var _S284 : s_minCtx_s_bwdCallableCtx_scattering_0;
    _S284.value0_23 = 0.0f;
    _S284.value1_6 = _S281;
    _S284.value2_1 = 0.0f;
    _S284.value3_0 = _S281;
    _S284.value4_0 = _S282;
    _S284.value5_0 = _S283;
    var _S285 : f32 = _S280.z;
    var by_cosine_0 : f32 = _S285 * 0.31830987334251404f;
    var _S286 : bool = (lobe_4.kind_0) == u32(0);
    var scattering_0 : Scattering_0;
    if(_S286)
    {
        scattering_0.value_1 = _S278.diffuse_reflectance_0 * vec3<f32>(by_cosine_0);
        scattering_0.pdf_0 = by_cosine_0;
    }
    var _S287 : bool = !_S286;
    if(_S287)
    {
        var _S288 : Tuple_10 = s_apply_Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
        var by_facets_0 : Mirrored_0;
        if(is_rough_0(lobe_4))
        {
            by_facets_0 = s_apply_mirrored_0(s_apply_facets_of_0(lobe_4, _S278).value0_26, _S279, _S280).value0_27;
        }
        else
        {
            by_facets_0 = _S288.value0_25;
        }
        var _runFlag_2 : bool;
        if((lobe_4.kind_0) == u32(2))
        {
            var _S289 : vec3<f32> = _S278.specular_reflectance_0 * (s_apply_fresnel_conductor_0(by_facets_0.cosine_0, _S278.eta_0, _S278.k_0).value0_31 * vec3<f32>(by_facets_0.scattered_0));
            _runFlag_2 = false;
            scattering_0.value_1 = _S289;
            scattering_0.pdf_0 = by_facets_0.pdf_1;
        }
        else
        {
            _runFlag_2 = _S287;
        }
        if(_runFlag_2)
        {
            var _S290 : Tuple_18 = s_apply_coat_eta_0(_S278);
            var _S291 : Tuple_20 = s_apply_transmittance_0(lobe_4, _S290.value0_33, _S279.z);
            _S284.value0_23 = _S291.value0_35;
            _S284.value1_6 = _S291.value1_8;
            var _S292 : Tuple_20 = s_apply_transmittance_0(lobe_4, _S290.value0_33, _S285);
            _S284.value2_1 = _S292.value0_35;
            _S284.value3_0 = _S292.value1_8;
            var _S293 : Tuple_22 = s_apply_base_0(lobe_4, _S290.value0_33, _S278.diffuse_reflectance_0);
            _S284.value4_0 = _S293.value0_37;
            _S284.value5_0 = _S293.value1_9;
            var _S294 : vec3<f32> = _S293.value0_37 * vec3<f32>((_S291.value0_35 * _S292.value0_35 * by_cosine_0 / (_S290.value0_33 * _S290.value0_33)));
            var probability_0 : f32 = base_probability_0(_S278, _S291.value0_35);
            var _S295 : f32 = probability_0 * by_cosine_0;
            if((lobe_4.kind_0) == u32(4))
            {
                var _S296 : f32 = _S295 + (1.0f - probability_0) * by_facets_0.pdf_1;
                scattering_0.value_1 = _S294 + _S278.specular_reflectance_0 * vec3<f32>((s_apply_fresnel_dielectric_0(by_facets_0.cosine_0, _S290.value0_33).value0_36 * by_facets_0.scattered_0));
                scattering_0.pdf_0 = _S296;
            }
            else
            {
                scattering_0.value_1 = _S294;
                scattering_0.pdf_0 = _S295;
            }
        }
    }
    var _S297 : Tuple_9;
    _S297.value0_24 = scattering_0;
    _S297.value1_7 = _S284;
    return _S297;
}

struct s_paramCtx_s_bwdCallableCtx_scattering_0
{
     value0_39 : Lobe_0,
     value1_10 : Numbers_0,
     value2_2 : vec3<f32>,
     value3_1 : vec3<f32>,
};

struct s_bwdCallableCtx_scattering_0
{
     value0_40 : s_paramCtx_s_bwdCallableCtx_scattering_0,
     value1_11 : s_minCtx_s_bwdCallableCtx_scattering_0,
};

struct s_paramCtx_s_bwdCallableCtx_facets_of_0
{
     value0_41 : Numbers_0,
};

struct s_paramCtx_s_bwdCallableCtx_mirrored_0
{
     value0_42 : Microfacets_0,
     value1_12 : vec3<f32>,
     value2_3 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0
{
     value0_43 : f32,
     value1_13 : vec3<f32>,
     value2_4 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_coat_eta_0
{
     value0_44 : Numbers_0,
};

struct s_paramCtx_s_bwdCallableCtx_transmittance_0
{
     value0_45 : Lobe_0,
     value1_14 : f32,
     value2_5 : f32,
};

struct s_paramCtx_s_bwdCallableCtx_base_0
{
     value0_46 : Lobe_0,
     value1_15 : f32,
     value2_6 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0
{
     value0_47 : f32,
     value1_16 : f32,
};

struct s_bwdCallableCtx_mirrored_0
{
     value0_48 : s_paramCtx_s_bwdCallableCtx_mirrored_0,
};

struct s_bwdCallableCtx_facets_of_0
{
     value0_49 : s_paramCtx_s_bwdCallableCtx_facets_of_0,
};

struct s_bwdCallableCtx_fresnel_conductor_0
{
     value0_50 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0,
};

struct s_bwdCallableCtx_fresnel_dielectric_0
{
     value0_51 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0,
};

struct s_bwdCallableCtx_base_0
{
     value0_52 : s_paramCtx_s_bwdCallableCtx_base_0,
     value1_17 : s_minCtx_s_bwdCallableCtx_base_0,
};

struct s_bwdCallableCtx_transmittance_0
{
     value0_53 : s_paramCtx_s_bwdCallableCtx_transmittance_0,
     value1_18 : s_minCtx_s_bwdCallableCtx_transmittance_0,
};

struct s_bwdCallableCtx_coat_eta_0
{
     value0_54 : s_paramCtx_s_bwdCallableCtx_coat_eta_0,
};

fn Numbers_x24_syn_dzero_0() -> Numbers_0
{
    var result_2 : Numbers_0;
    var _S298 : vec3<f32> = vec3<f32>(0.0f);
    result_2.diffuse_reflectance_0 = _S298;
    result_2.specular_reflectance_0 = _S298;
    result_2.eta_0 = _S298;
    result_2.k_0 = _S298;
    result_2.alpha_0 = vec2<f32>(0.0f);
    return result_2;
}

fn Mirrored_x24_syn_dzero_0() -> Mirrored_0
{
    var result_3 : Mirrored_0;
    result_3.cosine_0 = 0.0f;
    result_3.pdf_1 = 0.0f;
    result_3.scattered_0 = 0.0f;
    return result_3;
}

fn Scattering_x24_syn_dzero_0() -> Scattering_Differential_0
{
    var result_4 : Scattering_Differential_0;
    result_4.value_0 = vec3<f32>(0.0f);
    return result_4;
}

fn Scattering_x24_syn_dadd_0( SLANG_anonymous_0_1 : Scattering_Differential_0,  SLANG_anonymous_1_1 : Scattering_Differential_0) -> Scattering_Differential_0
{
    var result_5 : Scattering_Differential_0;
    result_5.value_0 = SLANG_anonymous_0_1.value_0 + SLANG_anonymous_1_1.value_0;
    return result_5;
}

fn s_bwdProp_fresnel_dielectric_0( _S299 : s_bwdCallableCtx_fresnel_dielectric_0,  _S300 : ptr<function, f32>,  _S301 : ptr<function, f32>,  _S302 : f32)
{
    var _S303 : f32 = _S299.value0_51.value1_16;
    var eta2_1 : f32 = _S303 * _S303;
    var _S304 : f32 = _S299.value0_51.value0_47;
    var cos2_3 : f32 = _S304 * _S304;
    var _S305 : f32 = _S299.value0_51.value1_16 - 1.0f;
    var _S306 : f32 = _S299.value0_51.value1_16 + 1.0f;
    var denser_1 : f32 = _S305 * _S306;
    var squared_1 : f32 = denser_1 + cos2_3;
    var _S307 : bool = !(squared_1 <= 0.0f);
    var _S308 : f32;
    var _S309 : f32;
    var _S310 : f32;
    var _S311 : f32;
    var _S312 : f32;
    var _S313 : f32;
    var _S314 : f32;
    var _S315 : f32;
    var _S316 : f32;
    var _S317 : f32;
    var _S318 : f32;
    var _S319 : s_bwdCallableCtx_sqrt_0;
    if(_S307)
    {
        var _S320 : Tuple_4 = s_apply_sqrt_0(squared_1);
        var _S321 : s_bwdCallableCtx_sqrt_0;
        _S321._S3 = squared_1;
        var s_sum_1 : f32 = _S299.value0_51.value0_47 + _S320.value0_6;
        var p_sum_2 : f32 = eta2_1 * _S299.value0_51.value0_47 + _S320.value0_6;
        var _S322 : f32 = s_sum_1 * s_sum_1;
        var senkrecht_1 : f32 = denser_1 / _S322;
        var _S323 : f32 = _S322 * _S322;
        var _S324 : f32 = eta2_1 + 1.0f;
        var _S325 : f32 = _S324 * cos2_3 - 1.0f;
        var _S326 : f32 = denser_1 * _S325;
        var _S327 : f32 = p_sum_2 * p_sum_2;
        var _S328 : f32 = _S327 * _S327;
        _S308 = _S326 / _S327;
        _S309 = senkrecht_1;
        _S310 = _S328;
        _S311 = _S326;
        _S312 = _S327;
        _S313 = p_sum_2;
        _S314 = _S325;
        _S315 = _S324;
        _S316 = _S323;
        _S317 = _S322;
        _S318 = s_sum_1;
        _S319 = _S321;
    }
    else
    {
        _S308 = 0.0f;
        _S309 = 0.0f;
        _S310 = 0.0f;
        _S311 = 0.0f;
        _S312 = 0.0f;
        _S313 = 0.0f;
        _S314 = 0.0f;
        _S315 = 0.0f;
        _S316 = 0.0f;
        _S317 = 0.0f;
        _S318 = 0.0f;
        _S319._S3 = 0.0f;
    }
    if(_S307)
    {
        var _S329 : f32 = 0.5f * _S302;
        var _S330 : f32 = _S308 * _S329;
        var _S331 : f32 = _S309 * _S329;
        var _S332 : f32 = (_S330 + _S330) / _S310;
        var _S333 : f32 = _S312 * _S332;
        var _S334 : f32 = _S313 * (_S311 * - _S332);
        var _S335 : f32 = denser_1 * _S333;
        var _S336 : f32 = _S314 * _S333;
        var _S337 : f32 = _S315 * _S335;
        var _S338 : f32 = cos2_3 * _S335;
        var _S339 : f32 = (_S331 + _S331) / _S316;
        var _S340 : f32 = _S317 * _S339;
        var _S341 : f32 = _S318 * (denser_1 * - _S339);
        var _S342 : f32 = _S334 + _S334;
        var _S343 : f32 = eta2_1 * _S342;
        var _S344 : f32 = _S299.value0_51.value0_47 * _S342;
        var _S345 : f32 = _S341 + _S341;
        var _S346 : f32 = _S342 + _S345;
        var _S347 : f32 = 0.0f;
        s_bwdProp_sqrt_0(_S319, &(_S347), _S346);
        var _S348 : f32 = _S338 + _S344;
        var _S349 : f32 = _S343 + _S345;
        var _S350 : f32 = _S336 + _S340;
        _S308 = _S347;
        _S309 = _S350;
        _S310 = _S337;
        _S311 = _S348;
        _S312 = _S349;
    }
    else
    {
        _S308 = 0.0f;
        _S309 = 0.0f;
        _S310 = 0.0f;
        _S311 = 0.0f;
        _S312 = 0.0f;
    }
    var _S351 : f32 = _S308 + _S309;
    var _S352 : f32 = _S299.value0_51.value0_47 * (_S308 + _S310);
    var _S353 : f32 = _S299.value0_51.value1_16 * _S311;
    var _S354 : f32 = _S305 * _S351 + _S306 * _S351 + _S353 + _S353;
    (*_S300) = _S352 + _S352 + _S312;
    (*_S301) = _S354;
    return;
}

fn Mirrored_x24_syn_dadd_0( SLANG_anonymous_0_2 : Mirrored_0,  SLANG_anonymous_1_2 : Mirrored_0) -> Mirrored_0
{
    var result_6 : Mirrored_0;
    result_6.cosine_0 = SLANG_anonymous_0_2.cosine_0 + SLANG_anonymous_1_2.cosine_0;
    result_6.pdf_1 = SLANG_anonymous_0_2.pdf_1 + SLANG_anonymous_1_2.pdf_1;
    result_6.scattered_0 = SLANG_anonymous_0_2.scattered_0 + SLANG_anonymous_1_2.scattered_0;
    return result_6;
}

fn Numbers_x24_syn_dadd_0( SLANG_anonymous_0_3 : Numbers_0,  SLANG_anonymous_1_3 : Numbers_0) -> Numbers_0
{
    var result_7 : Numbers_0;
    result_7.diffuse_reflectance_0 = SLANG_anonymous_0_3.diffuse_reflectance_0 + SLANG_anonymous_1_3.diffuse_reflectance_0;
    result_7.specular_reflectance_0 = SLANG_anonymous_0_3.specular_reflectance_0 + SLANG_anonymous_1_3.specular_reflectance_0;
    result_7.eta_0 = SLANG_anonymous_0_3.eta_0 + SLANG_anonymous_1_3.eta_0;
    result_7.k_0 = SLANG_anonymous_0_3.k_0 + SLANG_anonymous_1_3.k_0;
    result_7.alpha_0 = SLANG_anonymous_0_3.alpha_0 + SLANG_anonymous_1_3.alpha_0;
    return result_7;
}

struct s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0
{
     value0_55 : f32,
};

struct s_bwdCallableCtx_fresnel_diffuse_0
{
     value0_56 : s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0,
};

fn s_bwdProp_fresnel_diffuse_0( _S355 : s_bwdCallableCtx_fresnel_diffuse_0,  _S356 : ptr<function, f32>,  _S357 : f32)
{
    var inverse_1 : f32 = 1.0f / _S355.value0_56.value0_55;
    var _S358 : f32 = _S355.value0_56.value0_55 * _S355.value0_56.value0_55;
    var _S359 : bool = (_S355.value0_56.value0_55) < 1.0f;
    var _S360 : f32;
    if(_S359)
    {
        _S360 = -1.43990004062652588f * _S355.value0_56.value0_55 + 0.70990002155303955f;
    }
    else
    {
        _S360 = 0.0f;
    }
    var _S361 : bool = !_S359;
    var _S362 : f32;
    var _S363 : f32;
    var _S364 : f32;
    var _S365 : f32;
    if(_S361)
    {
        var _S366 : f32 = -1.36881005764007568f * inverse_1 + 4.98553991317749023f;
        var _S367 : f32 = _S366 * inverse_1 - 7.80988979339599609f;
        var sum_1 : f32 = _S367 * inverse_1 + 6.75334978103637695f;
        _S362 = sum_1 * inverse_1 - 3.47930002212524414f;
        _S363 = sum_1;
        _S364 = _S367;
        _S365 = _S366;
    }
    else
    {
        _S362 = 0.0f;
        _S363 = 0.0f;
        _S364 = 0.0f;
        _S365 = 0.0f;
    }
    if(_S361)
    {
        var _S368 : f32 = inverse_1 * _S357;
        var s_diff_sum_T_0 : f32 = inverse_1 * _S368;
        var _S369 : f32 = inverse_1 * s_diff_sum_T_0;
        var _S370 : f32 = _S362 * _S357 + _S363 * _S368 + _S364 * s_diff_sum_T_0 + _S365 * _S369 + -1.36881005764007568f * (inverse_1 * _S369);
        _S362 = 0.0f;
        _S363 = _S370;
    }
    else
    {
        _S362 = _S357;
        _S363 = 0.0f;
    }
    if(_S359)
    {
        var _S371 : f32 = _S360 * _S362 + -1.43990004062652588f * (_S355.value0_56.value0_55 * _S362);
        _S360 = 0.06360000371932983f * _S362 + _S363;
        _S362 = _S371;
    }
    else
    {
        _S360 = _S363;
        _S362 = 0.0f;
    }
    (*_S356) = - (_S360 / _S358) + _S362;
    return;
}

fn s_bwdProp_base_0( _S372 : s_bwdCallableCtx_base_0,  _S373 : ptr<function, f32>,  _S374 : ptr<function, vec3<f32>>,  _S375 : vec3<f32>)
{
    var _S376 : s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0 = s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0( 0.0f );
    var _S377 : vec3<f32> = vec3<f32>(0.0f);
    var _S378 : bool = (_S372.value0_52.value0_46.kind_0) == u32(3);
    var internal_reflectance_1 : f32;
    var _S379 : f32;
    var _S380 : s_bwdCallableCtx_fresnel_diffuse_0;
    if(_S378)
    {
        var _S381 : f32 = 1.0f / _S372.value0_52.value1_15;
        var _S382 : f32 = _S372.value0_52.value1_15 * _S372.value0_52.value1_15;
        var _S383 : Tuple_23 = s_apply_fresnel_diffuse_0(_S381);
        var _S384 : s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0;
        _S384.value0_55 = _S381;
        internal_reflectance_1 = _S383.value0_38;
        _S380.value0_56 = _S384;
        _S379 = _S382;
    }
    else
    {
        internal_reflectance_1 = _S372.value1_17.value0_22;
        _S380.value0_56 = _S376;
        _S379 = 0.0f;
    }
    var _S385 : vec3<f32> = vec3<f32>(internal_reflectance_1);
    var _S386 : bool = (_S372.value1_17.value1_5) == u32(0);
    var _S387 : f32;
    var _S388 : vec3<f32>;
    if(_S386)
    {
        var _S389 : f32 = 1.0f - internal_reflectance_1;
        var _S390 : f32 = _S389 * _S389;
        _S388 = vec3<f32>((1.0f / _S389));
        _S387 = _S390;
    }
    else
    {
        _S388 = _S377;
        _S387 = 0.0f;
    }
    var _S391 : bool = !_S386;
    var _S392 : vec3<f32>;
    var _S393 : vec3<f32>;
    if(_S391)
    {
        var _S394 : vec3<f32> = vec3<f32>(1.0f) - _S372.value0_52.value2_6 * vec3<f32>(internal_reflectance_1);
        _S392 = _S394 * _S394;
        _S393 = _S394;
    }
    else
    {
        _S392 = _S377;
        _S393 = _S377;
    }
    var _S395 : vec3<f32>;
    if(_S391)
    {
        var _S396 : vec3<f32> = _S375 / _S392;
        var _S397 : vec3<f32> = (vec3<f32>(0) - _S372.value0_52.value2_6 * (vec3<f32>(0) - _S396));
        var _S398 : vec3<f32> = _S372.value0_52.value2_6 * _S397;
        var _S399 : vec3<f32> = _S393 * _S396 + _S385 * _S397;
        _S392 = _S377;
        _S393 = _S399;
        _S395 = _S398;
    }
    else
    {
        _S392 = _S375;
        _S393 = _S377;
        _S395 = _S377;
    }
    if(_S386)
    {
        var _S400 : vec3<f32> = _S372.value0_52.value2_6 * _S392;
        var _S401 : vec3<f32> = _S388 * _S392 + _S393;
        internal_reflectance_1 = - - ((_S400[i32(0)] + _S400[i32(1)] + _S400[i32(2)]) / _S387);
        _S388 = _S401;
    }
    else
    {
        internal_reflectance_1 = 0.0f;
        _S388 = _S393;
    }
    var _S402 : f32 = _S395[i32(0)] + _S395[i32(1)] + _S395[i32(2)] + internal_reflectance_1;
    if(_S378)
    {
        var _S403 : f32 = 0.0f;
        s_bwdProp_fresnel_diffuse_0(_S380, &(_S403), _S402);
        internal_reflectance_1 = - (_S403 / _S379);
    }
    else
    {
        internal_reflectance_1 = 0.0f;
    }
    (*_S373) = internal_reflectance_1;
    (*_S374) = _S388;
    return;
}

fn s_bwdProp_transmittance_0( _S404 : s_bwdCallableCtx_transmittance_0,  _S405 : ptr<function, f32>,  _S406 : ptr<function, f32>,  _S407 : f32)
{
    var _S408 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0 = s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0( 0.0f, 0.0f );
    var _S409 : bool = (_S404.value0_53.value0_45.kind_0) == u32(3);
    var _S410 : s_bwdCallableCtx_fresnel_dielectric_0;
    if(_S409)
    {
        var _S411 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0;
        _S411.value0_47 = _S404.value0_53.value2_5;
        _S411.value1_16 = _S404.value0_53.value1_14;
        _S410.value0_51 = _S411;
    }
    else
    {
        _S410.value0_51 = _S408;
    }
    var _S412 : bool = !_S409;
    var _S413 : f32;
    if(_S412)
    {
        _S413 = _S404.value1_18.value1_4 - _S404.value1_18.value0_21;
    }
    else
    {
        _S413 = 0.0f;
    }
    var _S414 : f32;
    if(_S412)
    {
        var _S415 : f32 = 63.0f * (_S413 * _S407);
        _S413 = 0.0f;
        _S414 = _S415;
    }
    else
    {
        _S413 = _S407;
        _S414 = 0.0f;
    }
    if(_S409)
    {
        var _S416 : f32 = - _S413;
        var _S417 : f32 = 0.0f;
        var _S418 : f32 = 0.0f;
        s_bwdProp_fresnel_dielectric_0(_S410, &(_S417), &(_S418), _S416);
        var _S419 : f32 = _S417 + _S414;
        _S413 = _S418;
        _S414 = _S419;
    }
    else
    {
        _S413 = 0.0f;
    }
    (*_S405) = _S413;
    (*_S406) = _S414;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_luminance_0
{
     value0_57 : vec3<f32>,
};

struct s_bwdCallableCtx_luminance_0
{
     value0_58 : s_paramCtx_s_bwdCallableCtx_luminance_0,
};

fn s_bwdProp_luminance_0( _S420 : s_bwdCallableCtx_luminance_0,  _S421 : ptr<function, vec3<f32>>,  _S422 : f32)
{
    var _S423 : s_bwdCallableCtx_dot_1;
    _S423._S79 = _S420.value0_58.value0_57;
    _S423._S80 = vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f);
    var _S424 : vec3<f32> = vec3<f32>(0.0f);
    var _S425 : vec3<f32> = _S424;
    var _S426 : vec3<f32> = _S424;
    s_bwdProp_dot_1(_S423, &(_S425), &(_S426), _S422);
    (*_S421) = _S425;
    return;
}

fn s_bwdProp_coat_eta_0( _S427 : s_bwdCallableCtx_coat_eta_0,  _S428 : ptr<function, Numbers_0>,  _S429 : f32)
{
    var _S430 : Tuple_19 = s_apply_luminance_0(_S427.value0_54.value0_44.eta_0);
    var _S431 : s_paramCtx_s_bwdCallableCtx_luminance_0;
    _S431.value0_57 = _S427.value0_54.value0_44.eta_0;
    var _S432 : s_bwdCallableCtx_luminance_0 = s_bwdCallableCtx_luminance_0( _S431 );
    var _S433 : Tuple_19 = s_apply_luminance_0(_S427.value0_54.value0_44.k_0);
    var _S434 : s_paramCtx_s_bwdCallableCtx_luminance_0;
    _S434.value0_57 = _S427.value0_54.value0_44.k_0;
    var _S435 : s_bwdCallableCtx_luminance_0 = s_bwdCallableCtx_luminance_0( _S434 );
    var _S436 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S437 : f32 = _S429 / (_S433.value0_34 * _S433.value0_34);
    var _S438 : f32 = _S430.value0_34 * - _S437;
    var _S439 : f32 = _S433.value0_34 * _S437;
    var _S440 : vec3<f32> = vec3<f32>(0.0f);
    var _S441 : vec3<f32> = _S440;
    s_bwdProp_luminance_0(_S435, &(_S441), _S438);
    var _S442 : vec3<f32> = _S440;
    s_bwdProp_luminance_0(_S432, &(_S442), _S439);
    var _S443 : Numbers_0 = _S436;
    _S443.k_0 = _S441;
    _S443.eta_0 = _S442;
    (*_S428) = Numbers_x24_syn_dadd_0(_S436, _S443);
    return;
}

struct s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0
{
     value0_59 : f32,
     value1_19 : f32,
     value2_7 : f32,
};

struct s_bwdCallableCtx_fresnel_conductor_channel_0
{
     value0_60 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0,
};

fn s_bwdProp_fresnel_conductor_channel_0( _S444 : s_bwdCallableCtx_fresnel_conductor_channel_0,  _S445 : ptr<function, f32>,  _S446 : ptr<function, f32>,  _S447 : ptr<function, f32>,  _S448 : f32)
{
    var _S449 : f32 = _S444.value0_60.value0_59;
    var cos2_4 : f32 = _S449 * _S449;
    var sin2_1 : f32 = 1.0f - cos2_4;
    var _S450 : f32 = _S444.value0_60.value1_19;
    var _S451 : f32 = _S444.value0_60.value2_7;
    var real_1 : f32 = _S450 * _S450 - _S451 * _S451 - sin2_1;
    var product_1 : f32 = _S444.value0_60.value1_19 * _S444.value0_60.value2_7;
    var _S452 : f32 = real_1 * real_1 + 4.0f * (product_1 * product_1);
    var _S453 : Tuple_4 = s_apply_sqrt_0(_S452);
    var _S454 : s_bwdCallableCtx_sqrt_0;
    _S454._S3 = _S452;
    var _S455 : s_bwdCallableCtx_sqrt_0 = _S454;
    var _S456 : bool = !((_S453.value0_6) == 0.0f);
    var a_3 : f32;
    var b_2 : f32;
    var _S457 : f32;
    var _S458 : f32;
    var _S459 : f32;
    var _S460 : f32;
    var _S461 : f32;
    var _S462 : f32;
    var _S463 : f32;
    var _S464 : f32;
    var _S465 : f32;
    var _S466 : f32;
    var _S467 : f32;
    var _S468 : f32;
    var _S469 : f32;
    var _S470 : bool;
    var _S471 : s_bwdCallableCtx_sqrt_0;
    var _S472 : s_bwdCallableCtx_abs_0;
    if(_S456)
    {
        var _S473 : Tuple_7 = s_apply_abs_0(real_1);
        var _S474 : s_bwdCallableCtx_abs_0;
        _S474._S88 = real_1;
        var _S475 : s_bwdCallableCtx_abs_0 = _S474;
        var _S476 : f32 = 0.5f * (_S453.value0_6 + _S473.value0_11);
        var _S477 : Tuple_4 = s_apply_sqrt_0(_S476);
        var _S478 : s_bwdCallableCtx_sqrt_0;
        _S478._S3 = _S476;
        var _S479 : s_bwdCallableCtx_sqrt_0 = _S478;
        var smaller_1 : f32 = product_1 / _S477.value0_6;
        var _S480 : f32 = _S477.value0_6 * _S477.value0_6;
        var _S481 : bool = real_1 < 0.0f;
        if(_S481)
        {
            a_3 = smaller_1;
        }
        else
        {
            a_3 = _S477.value0_6;
        }
        if(_S481)
        {
            b_2 = _S477.value0_6;
        }
        else
        {
            b_2 = smaller_1;
        }
        var less_1 : f32 = a_3 - _S444.value0_60.value0_59;
        var more_1 : f32 = a_3 + _S444.value0_60.value0_59;
        var _S482 : f32 = b_2 * b_2;
        var _S483 : f32 = less_1 * less_1 + _S482;
        var _S484 : f32 = more_1 * more_1 + _S482;
        var senkrecht_2 : f32 = _S483 / _S484;
        var _S485 : f32 = _S484 * _S484;
        var p_sum_3 : f32 = _S453.value0_6 * cos2_4 + sin2_1 * sin2_1;
        var _S486 : f32 = senkrecht_2 * p_sum_3;
        var _S487 : f32 = 2.0f * a_3;
        var _S488 : f32 = _S487 * _S444.value0_60.value0_59;
        var _S489 : f32 = p_sum_3 + _S488 * sin2_1;
        var _S490 : f32 = b_2;
        a_3 = _S489 * _S489;
        b_2 = _S486;
        _S457 = _S489;
        _S458 = _S488;
        _S459 = _S487;
        _S460 = senkrecht_2;
        _S461 = p_sum_3;
        _S462 = _S485;
        _S463 = _S483;
        _S464 = _S484;
        _S465 = more_1;
        _S466 = _S490;
        _S467 = less_1;
        _S470 = _S481;
        _S468 = _S480;
        _S469 = _S477.value0_6;
        _S471 = _S479;
        _S472 = _S475;
    }
    else
    {
        a_3 = 0.0f;
        b_2 = 0.0f;
        _S457 = 0.0f;
        _S458 = 0.0f;
        _S459 = 0.0f;
        _S460 = 0.0f;
        _S461 = 0.0f;
        _S462 = 0.0f;
        _S463 = 0.0f;
        _S464 = 0.0f;
        _S465 = 0.0f;
        _S466 = 0.0f;
        _S467 = 0.0f;
        _S470 = false;
        _S468 = 0.0f;
        _S469 = 0.0f;
        _S471._S3 = 0.0f;
        _S472._S88 = 0.0f;
    }
    if(_S456)
    {
        var _S491 : f32 = _S448 / a_3;
        var _S492 : f32 = b_2 * - _S491;
        var _S493 : f32 = _S457 * _S491;
        var _S494 : f32 = sin2_1 * _S492;
        var _S495 : f32 = _S492 + _S460 * _S493;
        var _S496 : f32 = sin2_1 * _S495;
        var _S497 : f32 = _S453.value0_6 * _S495;
        var _S498 : f32 = cos2_4 * _S495;
        var _S499 : f32 = _S461 * _S493 / _S462;
        var _S500 : f32 = _S463 * - _S499;
        var _S501 : f32 = _S464 * _S499;
        var _S502 : f32 = _S465 * _S500;
        var _S503 : f32 = _S466 * (_S500 + _S501);
        var _S504 : f32 = _S467 * _S501;
        var _S505 : f32 = _S502 + _S502;
        var _S506 : f32 = _S504 + _S504;
        var _S507 : f32 = _S503 + _S503;
        var _S508 : f32 = 2.0f * (_S444.value0_60.value0_59 * _S494) + _S505 + _S506;
        var _S509 : f32 = _S458 * _S492 + _S496 + _S496;
        var _S510 : f32 = _S459 * _S494 + _S505 + - _S506;
        if(_S470)
        {
            a_3 = 0.0f;
            b_2 = _S507;
        }
        else
        {
            a_3 = _S507;
            b_2 = 0.0f;
        }
        if(_S470)
        {
            a_3 = _S508 + a_3;
        }
        else
        {
            b_2 = _S508 + b_2;
        }
        var _S511 : f32 = a_3 / _S468;
        var _S512 : f32 = _S469 * _S511;
        var _S513 : f32 = product_1 * - _S511 + b_2;
        var _S514 : f32 = 0.0f;
        s_bwdProp_sqrt_0(_S471, &(_S514), _S513);
        var _S515 : f32 = 0.5f * _S514;
        var _S516 : f32 = 0.0f;
        s_bwdProp_abs_0(_S472, &(_S516), _S515);
        a_3 = _S515 + _S498;
        b_2 = _S512;
        _S457 = _S516;
        _S458 = _S509;
        _S459 = _S497;
        _S460 = _S510;
    }
    else
    {
        a_3 = 0.0f;
        b_2 = 0.0f;
        _S457 = 0.0f;
        _S458 = 0.0f;
        _S459 = 0.0f;
        _S460 = 0.0f;
    }
    var _S517 : f32 = 0.0f;
    s_bwdProp_sqrt_0(_S455, &(_S517), a_3);
    var _S518 : f32 = product_1 * (4.0f * _S517);
    var _S519 : f32 = real_1 * _S517;
    var _S520 : f32 = _S518 + _S518 + b_2;
    var _S521 : f32 = _S519 + _S519 + _S457;
    var _S522 : f32 = - _S521;
    var _S523 : f32 = _S444.value0_60.value2_7 * _S522;
    var _S524 : f32 = _S444.value0_60.value1_19 * _S521;
    var _S525 : f32 = _S444.value0_60.value0_59 * (- (_S522 + _S458) + _S459);
    var _S526 : f32 = _S444.value0_60.value2_7 * _S520 + _S524 + _S524;
    var _S527 : f32 = _S444.value0_60.value1_19 * _S520 + _S523 + _S523;
    (*_S445) = _S525 + _S525 + _S460;
    (*_S446) = _S526;
    (*_S447) = _S527;
    return;
}

fn s_bwdProp_fresnel_conductor_0( _S528 : s_bwdCallableCtx_fresnel_conductor_0,  _S529 : ptr<function, f32>,  _S530 : ptr<function, vec3<f32>>,  _S531 : ptr<function, vec3<f32>>,  _S532 : vec3<f32>)
{
    var _S533 : f32 = _S528.value0_50.value1_13.x;
    var _S534 : f32 = _S528.value0_50.value2_4.x;
    var _S535 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0;
    _S535.value0_59 = _S528.value0_50.value0_43;
    _S535.value1_19 = _S533;
    _S535.value2_7 = _S534;
    var _S536 : s_bwdCallableCtx_fresnel_conductor_channel_0 = s_bwdCallableCtx_fresnel_conductor_channel_0( _S535 );
    var _S537 : f32 = _S528.value0_50.value1_13.y;
    var _S538 : f32 = _S528.value0_50.value2_4.y;
    var _S539 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0;
    _S539.value0_59 = _S528.value0_50.value0_43;
    _S539.value1_19 = _S537;
    _S539.value2_7 = _S538;
    var _S540 : s_bwdCallableCtx_fresnel_conductor_channel_0 = s_bwdCallableCtx_fresnel_conductor_channel_0( _S539 );
    var _S541 : f32 = _S528.value0_50.value1_13.z;
    var _S542 : f32 = _S528.value0_50.value2_4.z;
    var _S543 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0;
    _S543.value0_59 = _S528.value0_50.value0_43;
    _S543.value1_19 = _S541;
    _S543.value2_7 = _S542;
    var _S544 : s_bwdCallableCtx_fresnel_conductor_channel_0 = s_bwdCallableCtx_fresnel_conductor_channel_0( _S543 );
    var _S545 : f32 = 0.0f;
    var _S546 : f32 = 0.0f;
    var _S547 : f32 = 0.0f;
    s_bwdProp_fresnel_conductor_channel_0(_S544, &(_S545), &(_S546), &(_S547), _S532[i32(2)]);
    var _S548 : f32 = 0.0f;
    var _S549 : f32 = 0.0f;
    var _S550 : f32 = 0.0f;
    s_bwdProp_fresnel_conductor_channel_0(_S540, &(_S548), &(_S549), &(_S550), _S532[i32(1)]);
    var _S551 : f32 = 0.0f;
    var _S552 : f32 = 0.0f;
    var _S553 : f32 = 0.0f;
    s_bwdProp_fresnel_conductor_channel_0(_S536, &(_S551), &(_S552), &(_S553), _S532[i32(0)]);
    var _S554 : vec3<f32> = vec3<f32>(_S553, _S550, _S547);
    var _S555 : vec3<f32> = vec3<f32>(_S552, _S549, _S546);
    (*_S529) = _S545 + _S548 + _S551;
    (*_S530) = _S555;
    (*_S531) = _S554;
    return;
}

struct Microfacets_Differential_0
{
     alpha_2 : vec2<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_density_0
{
     value0_61 : Microfacets_0,
     value1_20 : vec3<f32>,
};

struct s_bwdCallableCtx_density_0
{
     value0_62 : s_paramCtx_s_bwdCallableCtx_density_0,
};

struct s_paramCtx_s_bwdCallableCtx_visible_over_cos_0
{
     value0_63 : Microfacets_0,
     value1_21 : vec3<f32>,
};

struct s_bwdCallableCtx_visible_over_cos_0
{
     value0_64 : s_paramCtx_s_bwdCallableCtx_visible_over_cos_0,
};

fn Microfacets_x24_syn_dzero_0() -> Microfacets_Differential_0
{
    var result_8 : Microfacets_Differential_0;
    result_8.alpha_2 = vec2<f32>(0.0f);
    return result_8;
}

fn Microfacets_x24_syn_dadd_0( SLANG_anonymous_0_4 : Microfacets_Differential_0,  SLANG_anonymous_1_4 : Microfacets_Differential_0) -> Microfacets_Differential_0
{
    var result_9 : Microfacets_Differential_0;
    result_9.alpha_2 = SLANG_anonymous_0_4.alpha_2 + SLANG_anonymous_1_4.alpha_2;
    return result_9;
}

fn s_bwdProp_visible_over_cos_0( _S556 : s_bwdCallableCtx_visible_over_cos_0,  _S557 : ptr<function, Microfacets_Differential_0>,  _S558 : ptr<function, vec3<f32>>,  _S559 : f32)
{
    var _S560 : vec2<f32> = _S556.value0_64.value1_21.xy;
    var stretched_1 : vec2<f32> = _S560 * _S556.value0_64.value0_63.alpha_1;
    var _S561 : Tuple_2 = s_apply_dot_0(stretched_1, stretched_1);
    var _S562 : s_bwdCallableCtx_dot_0;
    _S562._S35 = stretched_1;
    _S562._S36 = stretched_1;
    var _S563 : s_bwdCallableCtx_dot_0 = _S562;
    var _S564 : f32 = _S556.value0_64.value1_21.z;
    var z2_1 : f32 = _S564 * _S564;
    var _S565 : bool = (_S556.value0_64.value0_63.distribution_1) == u32(1);
    var _S566 : f32;
    var _S567 : s_bwdCallableCtx_sqrt_0;
    if(_S565)
    {
        var _S568 : f32 = z2_1 + _S561.value0_4;
        var _S569 : Tuple_4 = s_apply_sqrt_0(_S568);
        var _S570 : s_bwdCallableCtx_sqrt_0;
        _S570._S3 = _S568;
        var _S571 : f32 = _S564 + _S569.value0_6;
        _S566 = _S571 * _S571;
        _S567 = _S570;
    }
    else
    {
        _S566 = 0.0f;
        _S567._S3 = 0.0f;
    }
    var _S572 : bool = !_S565;
    var _S573 : f32;
    var _S574 : f32;
    var _S575 : f32;
    var _S576 : f32;
    var _S577 : f32;
    var _S578 : f32;
    var _S579 : f32;
    var _S580 : s_bwdCallableCtx_sqrt_0;
    var _runFlag_3 : bool;
    var _S581 : bool;
    var _S582 : s_bwdCallableCtx_error_function_plus_one_0;
    if(_S572)
    {
        var _S583 : bool = z2_1 >= (36.0f * _S561.value0_4);
        if(_S583)
        {
            _runFlag_3 = false;
            _S573 = z2_1;
        }
        else
        {
            _runFlag_3 = _S572;
            _S573 = 0.0f;
        }
        if(_runFlag_3)
        {
            var _S584 : Tuple_4 = s_apply_sqrt_0(_S561.value0_4);
            var _S585 : s_bwdCallableCtx_sqrt_0;
            _S585._S3 = _S561.value0_4;
            var _S586 : f32 = _S564 / _S584.value0_6;
            var _S587 : f32 = _S584.value0_6 * _S584.value0_6;
            var _S588 : Tuple_1 = s_apply_error_function_plus_one_0(_S586);
            var _S589 : s_bwdCallableCtx_error_function_plus_one_0;
            _S589._S31 = _S586;
            var _S590 : f32 = _S588.value0_3.x;
            var _S591 : f32 = 0.5f * _S584.value0_6;
            var _S592 : f32 = _S588.value0_3.y;
            var _S593 : f32 = _S564 * _S590 + _S591 * _S592;
            _S574 = _S593 * _S593;
            _S575 = _S591;
            _S576 = _S592;
            _S577 = _S590;
            _S582 = _S589;
            _S578 = _S587;
            _S579 = _S584.value0_6;
            _S580 = _S585;
        }
        else
        {
            _S574 = 0.0f;
            _S575 = 0.0f;
            _S576 = 0.0f;
            _S577 = 0.0f;
            _S582._S31 = 0.0f;
            _S578 = 0.0f;
            _S579 = 0.0f;
            _S580._S3 = 0.0f;
        }
        var _S594 : f32 = _S573;
        _S573 = _S574;
        _S574 = _S575;
        _S575 = _S576;
        _S576 = _S577;
        _S577 = _S578;
        _S578 = _S579;
        _S581 = _S583;
        _S579 = _S594;
    }
    else
    {
        _runFlag_3 = false;
        _S573 = 0.0f;
        _S574 = 0.0f;
        _S575 = 0.0f;
        _S576 = 0.0f;
        _S582._S31 = 0.0f;
        _S577 = 0.0f;
        _S578 = 0.0f;
        _S580._S3 = 0.0f;
        _S581 = false;
        _S579 = 0.0f;
    }
    var _S595 : Microfacets_Differential_0 = Microfacets_x24_syn_dzero_0();
    if(_S572)
    {
        if(_runFlag_3)
        {
            var _S596 : f32 = 2.0f * - (_S559 / _S573);
            var _S597 : f32 = 0.5f * (_S575 * _S596);
            var _S598 : f32 = _S576 * _S596;
            var _S599 : vec2<f32> = vec2<f32>(_S564 * _S596, _S574 * _S596);
            var _S600 : f32 = 0.0f;
            s_bwdProp_error_function_plus_one_0(_S582, &(_S600), _S599);
            var _S601 : f32 = _S600 / _S577;
            var _S602 : f32 = _S578 * _S601;
            var _S603 : f32 = _S597 + _S564 * - _S601;
            var _S604 : f32 = 0.0f;
            s_bwdProp_sqrt_0(_S580, &(_S604), _S603);
            var _S605 : f32 = _S598 + _S602;
            _S573 = 0.0f;
            _S574 = _S605;
            _S575 = _S604;
        }
        else
        {
            _S573 = _S559;
            _S574 = 0.0f;
            _S575 = 0.0f;
        }
        if(_S581)
        {
            var _S606 : f32 = - (_S573 / _S579) + _S574;
            _S573 = 0.0f;
            _S574 = _S606;
        }
    }
    else
    {
        _S573 = _S559;
        _S574 = 0.0f;
        _S575 = 0.0f;
    }
    if(_S565)
    {
        var _S607 : f32 = 2.0f * - (_S573 / _S566);
        var _S608 : f32 = 0.0f;
        s_bwdProp_sqrt_0(_S567, &(_S608), _S607);
        var _S609 : f32 = _S607 + _S574;
        var _S610 : f32 = _S608 + _S575;
        _S566 = _S608;
        _S573 = _S609;
        _S574 = _S610;
    }
    else
    {
        _S566 = 0.0f;
        _S573 = _S574;
        _S574 = _S575;
    }
    var _S611 : f32 = _S564 * _S566;
    var _S612 : f32 = _S611 + _S611 + _S573;
    var _S613 : vec2<f32> = vec2<f32>(0.0f);
    var _S614 : vec2<f32> = _S613;
    var _S615 : vec2<f32> = _S613;
    s_bwdProp_dot_0(_S563, &(_S614), &(_S615), _S574);
    var _S616 : vec2<f32> = _S614 + _S615;
    var _S617 : vec2<f32> = _S560 * _S616;
    var _S618 : vec2<f32> = _S556.value0_64.value0_63.alpha_1 * _S616;
    var _S619 : vec3<f32> = vec3<f32>(_S618[i32(0)], _S618[i32(1)], _S612);
    var _S620 : Microfacets_Differential_0 = _S595;
    _S620.alpha_2 = _S617;
    (*_S557) = Microfacets_x24_syn_dadd_0(_S595, _S620);
    (*_S558) = _S619;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_exponential_0
{
     value0_65 : f32,
};

struct s_bwdCallableCtx_exponential_0
{
     value0_66 : s_paramCtx_s_bwdCallableCtx_exponential_0,
};

fn s_bwdProp_exponential_0( _S621 : s_bwdCallableCtx_exponential_0,  _S622 : ptr<function, f32>,  _S623 : f32)
{
    var _S624 : bool = !((_S621.value0_66.value0_65) < -87.0f);
    var _S625 : f32;
    var _S626 : f32;
    var _S627 : f32;
    var _S628 : f32;
    var _S629 : f32;
    var _S630 : f32;
    var _S631 : f32;
    var _S632 : f32;
    if(_S624)
    {
        var power_2 : f32 = floor(_S621.value0_66.value0_65 * 1.4426950216293335f + 0.5f);
        var r_2 : f32 = _S621.value0_66.value0_65 - power_2 * 0.693359375f + power_2 * 0.00021219444170129f;
        var _S633 : f32 = 0.00019875691214111f * r_2 + 0.00139819993637502f;
        var _S634 : f32 = _S633 * r_2 + 0.00833345204591751f;
        var tail_0 : f32 = _S634 * r_2 + 0.04166579619050026f;
        var _S635 : f32 = tail_0 * r_2 + 0.1666666567325592f;
        var tail_1 : f32 = _S635 * r_2 + 0.5f;
        var _S636 : f32 = tail_1 * r_2;
        _S625 = (bitcast<f32>(((u32(i32(power_2) + i32(127)) << (u32(23))))));
        _S626 = _S636;
        _S627 = r_2;
        _S628 = tail_1;
        _S629 = _S635;
        _S630 = tail_0;
        _S631 = _S634;
        _S632 = _S633;
    }
    else
    {
        _S625 = 0.0f;
        _S626 = 0.0f;
        _S627 = 0.0f;
        _S628 = 0.0f;
        _S629 = 0.0f;
        _S630 = 0.0f;
        _S631 = 0.0f;
        _S632 = 0.0f;
    }
    if(_S624)
    {
        var _S637 : f32 = _S625 * _S623;
        var _S638 : f32 = _S627 * _S637;
        var s_diff_tail_T_0 : f32 = _S627 * _S638;
        var _S639 : f32 = _S627 * s_diff_tail_T_0;
        var s_diff_tail_T_1 : f32 = _S627 * _S639;
        var _S640 : f32 = _S627 * s_diff_tail_T_1;
        _S625 = _S637 + _S626 * _S637 + _S628 * _S638 + _S629 * s_diff_tail_T_0 + _S630 * _S639 + _S631 * s_diff_tail_T_1 + _S632 * _S640 + 0.00019875691214111f * (_S627 * _S640);
    }
    else
    {
        _S625 = 0.0f;
    }
    (*_S622) = _S625;
    return;
}

fn s_bwdProp_density_0( _S641 : s_bwdCallableCtx_density_0,  _S642 : ptr<function, Microfacets_Differential_0>,  _S643 : ptr<function, vec3<f32>>,  _S644 : f32)
{
    var _S645 : vec2<f32> = vec2<f32>(0.0f);
    var _S646 : s_paramCtx_s_bwdCallableCtx_exponential_0 = s_paramCtx_s_bwdCallableCtx_exponential_0( 0.0f );
    var _S647 : f32 = _S641.value0_62.value1_20.z;
    var _S648 : bool = !(_S647 <= 0.0f);
    var _runFlag_4 : bool;
    var _S649 : bool;
    var _S650 : bool;
    var _S651 : f32;
    var _S652 : f32;
    var _S653 : f32;
    var _S654 : f32;
    var _S655 : f32;
    var _S656 : f32;
    var _S657 : f32;
    var _S658 : f32;
    var _S659 : f32;
    var _S660 : f32;
    var _S661 : f32;
    var _S662 : f32;
    var _S663 : f32;
    var _S664 : s_bwdCallableCtx_exponential_0;
    var _S665 : s_bwdCallableCtx_dot_0;
    var _S666 : vec2<f32>;
    var _S667 : vec2<f32>;
    var _S668 : vec2<f32>;
    if(_S648)
    {
        var _S669 : f32 = 3.14159274101257324f * _S641.value0_62.value0_61.alpha_1.x;
        var _S670 : f32 = _S641.value0_62.value0_61.alpha_1.y;
        var scale_1 : f32 = _S669 * _S670;
        var _S671 : vec2<f32> = _S641.value0_62.value1_20.xy;
        var slope_2 : vec2<f32> = _S671 / _S641.value0_62.value0_61.alpha_1;
        var _S672 : vec2<f32> = _S641.value0_62.value0_61.alpha_1 * _S641.value0_62.value0_61.alpha_1;
        var _S673 : Tuple_2 = s_apply_dot_0(slope_2, slope_2);
        var _S674 : s_bwdCallableCtx_dot_0;
        _S674._S35 = slope_2;
        _S674._S36 = slope_2;
        var _S675 : s_bwdCallableCtx_dot_0 = _S674;
        var cos2_5 : f32 = _S647 * _S647;
        var _S676 : bool = (_S641.value0_62.value0_61.distribution_1) == u32(1);
        if(_S676)
        {
            var sum_2 : f32 = _S673.value0_4 + cos2_5;
            var _S677 : f32 = scale_1 * sum_2;
            var _S678 : f32 = _S677 * sum_2;
            var _S679 : f32 = _S678 * _S678;
            _runFlag_4 = false;
            _S651 = _S679;
            _S652 = _S677;
            _S653 = sum_2;
        }
        else
        {
            _runFlag_4 = _S648;
            _S651 = 0.0f;
            _S652 = 0.0f;
            _S653 = 0.0f;
        }
        if(_runFlag_4)
        {
            var exponent_1 : f32 = _S673.value0_4 / cos2_5;
            var _S680 : f32 = cos2_5 * cos2_5;
            var _S681 : bool = exponent_1 > 80.0f;
            if(_S681)
            {
                _S654 = 0.0f;
                _S655 = 0.0f;
                _S656 = 0.0f;
                _S657 = 0.0f;
                _S664.value0_66 = _S646;
            }
            else
            {
                var _S682 : f32 = - exponent_1;
                var _S683 : Tuple_14 = s_apply_exponential_0(_S682);
                var _S684 : s_paramCtx_s_bwdCallableCtx_exponential_0;
                _S684.value0_65 = _S682;
                var _S685 : f32 = scale_1 * cos2_5;
                var _S686 : f32 = _S685 * cos2_5;
                _S654 = _S686 * _S686;
                _S655 = _S683.value0_29;
                _S656 = _S686;
                _S657 = _S685;
                _S664.value0_66 = _S684;
            }
            _S649 = _S681;
            _S658 = _S680;
        }
        else
        {
            _S649 = false;
            _S654 = 0.0f;
            _S655 = 0.0f;
            _S656 = 0.0f;
            _S657 = 0.0f;
            _S664.value0_66 = _S646;
            _S658 = 0.0f;
        }
        var _S687 : f32 = _S651;
        var _S688 : f32 = _S652;
        var _S689 : f32 = _S653;
        _S651 = _S654;
        _S652 = _S655;
        _S653 = _S656;
        _S654 = _S657;
        _S655 = cos2_5;
        _S656 = scale_1;
        _S657 = _S658;
        _S658 = _S673.value0_4;
        _S650 = _S676;
        _S659 = _S687;
        _S660 = _S688;
        _S661 = _S689;
        _S665 = _S675;
        _S666 = _S672;
        _S667 = _S671;
        _S668 = _S641.value0_62.value0_61.alpha_1;
        _S662 = _S669;
        _S663 = _S670;
    }
    else
    {
        _runFlag_4 = false;
        _S649 = false;
        _S651 = 0.0f;
        _S652 = 0.0f;
        _S653 = 0.0f;
        _S654 = 0.0f;
        _S655 = 0.0f;
        _S656 = 0.0f;
        _S664.value0_66 = _S646;
        _S657 = 0.0f;
        _S658 = 0.0f;
        _S650 = false;
        _S659 = 0.0f;
        _S660 = 0.0f;
        _S661 = 0.0f;
        _S665._S35 = _S645;
        _S665._S36 = _S645;
        _S666 = _S645;
        _S667 = _S645;
        _S668 = _S645;
        _S662 = 0.0f;
        _S663 = 0.0f;
    }
    var _S690 : Microfacets_Differential_0 = Microfacets_x24_syn_dzero_0();
    var _S691 : vec3<f32> = vec3<f32>(0.0f);
    var _S692 : vec3<f32>;
    var _S693 : Microfacets_Differential_0;
    if(_S648)
    {
        if(_runFlag_4)
        {
            if(_S649)
            {
                _S651 = 0.0f;
                _S652 = 0.0f;
                _S653 = 0.0f;
            }
            else
            {
                var _S694 : f32 = _S644 / _S651;
                var _S695 : f32 = _S652 * - _S694;
                var _S696 : f32 = _S653 * _S694;
                var _S697 : f32 = _S654 * _S695;
                var _S698 : f32 = _S655 * _S695;
                var _S699 : f32 = _S656 * _S698;
                var _S700 : f32 = _S655 * _S698;
                var _S701 : f32 = 0.0f;
                s_bwdProp_exponential_0(_S664, &(_S701), _S696);
                var _S702 : f32 = _S697 + _S699;
                _S651 = - _S701;
                _S652 = _S702;
                _S653 = _S700;
            }
            var _S703 : f32 = _S651 / _S657;
            var _S704 : f32 = _S655 * _S703;
            var _S705 : f32 = _S658 * - _S703 + _S652;
            _S651 = 0.0f;
            _S652 = _S653;
            _S653 = _S704;
            _S654 = _S705;
        }
        else
        {
            _S651 = _S644;
            _S652 = 0.0f;
            _S653 = 0.0f;
            _S654 = 0.0f;
        }
        if(_S650)
        {
            var _S706 : f32 = - (_S651 / _S659);
            var _S707 : f32 = _S661 * _S706;
            var _S708 : f32 = _S660 * _S706 + _S656 * _S707;
            var _S709 : f32 = _S661 * _S707 + _S652;
            var _S710 : f32 = _S708 + _S653;
            _S651 = _S708 + _S654;
            _S652 = _S710;
            _S653 = _S709;
        }
        else
        {
            var _S711 : f32 = _S652;
            _S651 = _S654;
            _S652 = _S653;
            _S653 = _S711;
        }
        var _S712 : f32 = _S647 * _S651;
        var _S713 : vec2<f32> = _S645;
        var _S714 : vec2<f32> = _S645;
        s_bwdProp_dot_0(_S665, &(_S713), &(_S714), _S652);
        var _S715 : vec2<f32> = (_S713 + _S714) / _S666;
        var _S716 : vec2<f32> = _S668 * _S715;
        var _S717 : vec2<f32> = _S667 * (vec2<f32>(0) - _S715) + vec2<f32>(3.14159274101257324f * (_S663 * _S653), _S662 * _S653);
        var _S718 : f32 = _S712 + _S712;
        var _S719 : vec3<f32> = vec3<f32>(_S716[i32(0)], _S716[i32(1)], 0.0f);
        var _S720 : Microfacets_Differential_0 = _S690;
        _S720.alpha_2 = _S717;
        var _S721 : Microfacets_Differential_0 = Microfacets_x24_syn_dadd_0(_S690, _S720);
        _S651 = _S718;
        _S692 = _S719;
        _S693 = _S721;
    }
    else
    {
        _S651 = 0.0f;
        _S692 = _S691;
        _S693 = _S690;
    }
    var _S722 : vec3<f32> = _S692 + vec3<f32>(0.0f, 0.0f, _S651);
    (*_S642) = _S693;
    (*_S643) = _S722;
    return;
}

fn s_bwdProp_mirrored_0( _S723 : s_bwdCallableCtx_mirrored_0,  _S724 : ptr<function, Microfacets_Differential_0>,  _S725 : ptr<function, vec3<f32>>,  _S726 : ptr<function, vec3<f32>>,  _S727 : Mirrored_0)
{
    var _S728 : vec3<f32> = _S723.value0_48.value1_12 + _S723.value0_48.value2_3;
    var _S729 : Tuple_5 = s_apply_normalize_0(_S728);
    var _S730 : s_bwdCallableCtx_normalize_0;
    _S730._S61 = _S728;
    var _S731 : s_bwdCallableCtx_dot_1;
    _S731._S79 = _S723.value0_48.value1_12;
    _S731._S80 = _S729.value0_7;
    var _S732 : Tuple_13 = s_apply_density_0(_S723.value0_48.value0_42, _S729.value0_7);
    var _S733 : s_paramCtx_s_bwdCallableCtx_density_0;
    _S733.value0_61 = _S723.value0_48.value0_42;
    _S733.value1_20 = _S729.value0_7;
    var _S734 : s_bwdCallableCtx_density_0 = s_bwdCallableCtx_density_0( _S733 );
    var _S735 : f32 = 0.25f * _S732.value0_28;
    var _S736 : Tuple_15 = s_apply_visible_over_cos_0(_S723.value0_48.value0_42, _S723.value0_48.value1_12);
    var _S737 : s_paramCtx_s_bwdCallableCtx_visible_over_cos_0;
    _S737.value0_63 = _S723.value0_48.value0_42;
    _S737.value1_21 = _S723.value0_48.value1_12;
    var _S738 : s_bwdCallableCtx_visible_over_cos_0 = s_bwdCallableCtx_visible_over_cos_0( _S737 );
    var _S739 : f32 = _S735 * _S736.value0_30;
    var _S740 : Tuple_15 = s_apply_visible_over_cos_0(_S723.value0_48.value0_42, _S723.value0_48.value2_3);
    var _S741 : s_paramCtx_s_bwdCallableCtx_visible_over_cos_0;
    _S741.value0_63 = _S723.value0_48.value0_42;
    _S741.value1_21 = _S723.value0_48.value2_3;
    var _S742 : s_bwdCallableCtx_visible_over_cos_0 = s_bwdCallableCtx_visible_over_cos_0( _S741 );
    var _S743 : Microfacets_Differential_0 = Microfacets_x24_syn_dzero_0();
    var _S744 : f32 = _S739 * _S740.value0_30 * _S727.scattered_0;
    var _S745 : f32 = _S723.value0_48.value2_3.z * _S727.scattered_0;
    var _S746 : f32 = _S739 * _S745;
    var _S747 : f32 = _S740.value0_30 * _S745;
    var _S748 : vec2<f32> = vec2<f32>(0.0f);
    var _S749 : Microfacets_Differential_0;
    _S749.alpha_2 = _S748;
    var _S750 : vec3<f32> = vec3<f32>(0.0f);
    var _S751 : vec3<f32> = _S750;
    s_bwdProp_visible_over_cos_0(_S742, &(_S749), &(_S751), _S746);
    var _S752 : f32 = _S727.pdf_1 + _S747;
    var _S753 : f32 = _S735 * _S752;
    var _S754 : f32 = _S736.value0_30 * _S752;
    var _S755 : Microfacets_Differential_0;
    _S755.alpha_2 = _S748;
    var _S756 : vec3<f32> = _S750;
    s_bwdProp_visible_over_cos_0(_S738, &(_S755), &(_S756), _S753);
    var _S757 : f32 = 0.25f * _S754;
    var _S758 : Microfacets_Differential_0;
    _S758.alpha_2 = _S748;
    var _S759 : vec3<f32> = _S750;
    s_bwdProp_density_0(_S734, &(_S758), &(_S759), _S757);
    var _S760 : vec3<f32> = _S750;
    var _S761 : vec3<f32> = _S750;
    s_bwdProp_dot_1(_S731, &(_S760), &(_S761), _S727.cosine_0);
    var _S762 : vec3<f32> = _S759 + _S761;
    var _S763 : vec3<f32> = _S750;
    s_bwdProp_normalize_0(_S730, &(_S763), _S762);
    var _S764 : vec3<f32> = _S756 + _S760 + _S763;
    var _S765 : vec3<f32> = _S751 + _S763 + vec3<f32>(0.0f, 0.0f, _S744);
    (*_S724) = Microfacets_x24_syn_dadd_0(Microfacets_x24_syn_dadd_0(Microfacets_x24_syn_dadd_0(_S749, _S755), _S758), _S743);
    (*_S725) = _S764;
    (*_S726) = _S765;
    return;
}

fn s_bwdProp_facets_of_0( _S766 : s_bwdCallableCtx_facets_of_0,  _S767 : ptr<function, Numbers_0>,  _S768 : Microfacets_Differential_0)
{
    var _S769 : vec2<f32> = vec2<f32>(0.00009999999747379f);
    var _S770 : s_bwdCallableCtx_max_0;
    _S770._S40 = _S766.value0_49.value0_41.alpha_0;
    _S770._S41 = _S769;
    var _S771 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S772 : vec2<f32> = vec2<f32>(0.0f);
    var _S773 : vec2<f32> = _S772;
    var _S774 : vec2<f32> = _S772;
    s_bwdProp_max_0(_S770, &(_S773), &(_S774), _S768.alpha_2);
    var _S775 : Numbers_0 = _S771;
    _S775.alpha_0 = _S773;
    (*_S767) = Numbers_x24_syn_dadd_0(_S771, _S775);
    return;
}

fn s_bwdProp_scattering_0( _S776 : s_bwdCallableCtx_scattering_0,  _S777 : ptr<function, Numbers_0>,  _S778 : ptr<function, vec3<f32>>,  _S779 : ptr<function, vec3<f32>>,  _S780 : Scattering_Differential_0)
{
    var _S781 : vec3<f32> = vec3<f32>(0.0f);
    var _S782 : vec2<f32> = vec2<f32>(0.0f);
    var _S783 : Numbers_0 = Numbers_0( _S781, _S781, _S781, _S781, _S782 );
    var _S784 : s_paramCtx_s_bwdCallableCtx_facets_of_0 = s_paramCtx_s_bwdCallableCtx_facets_of_0( _S783 );
    var _S785 : Microfacets_0 = Microfacets_0( u32(0), _S782 );
    var _S786 : s_paramCtx_s_bwdCallableCtx_mirrored_0 = s_paramCtx_s_bwdCallableCtx_mirrored_0( _S785, _S781, _S781 );
    var _S787 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0 = s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0( 0.0f, _S781, _S781 );
    var _S788 : s_paramCtx_s_bwdCallableCtx_coat_eta_0 = s_paramCtx_s_bwdCallableCtx_coat_eta_0( _S783 );
    var _S789 : Lobe_0 = Lobe_0( u32(0), u32(0), u32(0), _S783 );
    var _S790 : s_paramCtx_s_bwdCallableCtx_transmittance_0 = s_paramCtx_s_bwdCallableCtx_transmittance_0( _S789, 0.0f, 0.0f );
    var _S791 : s_minCtx_s_bwdCallableCtx_transmittance_0 = s_minCtx_s_bwdCallableCtx_transmittance_0( 0.0f, 0.0f );
    var _S792 : s_paramCtx_s_bwdCallableCtx_base_0 = s_paramCtx_s_bwdCallableCtx_base_0( _S789, 0.0f, _S781 );
    var _S793 : s_minCtx_s_bwdCallableCtx_base_0 = s_minCtx_s_bwdCallableCtx_base_0( 0.0f, u32(0) );
    var _S794 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0 = s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0( 0.0f, 0.0f );
    var _S795 : f32 = _S776.value0_40.value3_1.z;
    var by_cosine_1 : f32 = _S795 * 0.31830987334251404f;
    var _S796 : vec3<f32> = vec3<f32>(by_cosine_1);
    var _S797 : bool = (_S776.value0_40.value0_39.kind_0) == u32(0);
    var _S798 : vec3<f32>;
    if(_S797)
    {
        _S798 = _S776.value0_40.value1_10.diffuse_reflectance_0;
    }
    else
    {
        _S798 = _S781;
    }
    var _S799 : bool = !_S797;
    var _S800 : vec3<f32>;
    var _S801 : vec3<f32>;
    var _S802 : vec3<f32>;
    var _S803 : vec3<f32>;
    var _S804 : vec3<f32>;
    var _S805 : vec3<f32>;
    var _S806 : vec3<f32>;
    var by_facets_1 : Mirrored_0;
    var _S807 : s_bwdCallableCtx_mirrored_0;
    var _S808 : s_bwdCallableCtx_facets_of_0;
    var _runFlag_5 : bool;
    var _S809 : bool;
    var _S810 : bool;
    var _S811 : bool;
    var _S812 : s_bwdCallableCtx_fresnel_conductor_0;
    var _S813 : f32;
    var _S814 : f32;
    var _S815 : f32;
    var _S816 : f32;
    var _S817 : f32;
    var _S818 : f32;
    var _S819 : f32;
    var _S820 : f32;
    var _S821 : f32;
    var _S822 : s_bwdCallableCtx_fresnel_dielectric_0;
    var _S823 : s_bwdCallableCtx_base_0;
    var _S824 : s_bwdCallableCtx_transmittance_0;
    var _S825 : s_bwdCallableCtx_transmittance_0;
    var _S826 : s_bwdCallableCtx_coat_eta_0;
    if(_S799)
    {
        var _S827 : Tuple_10 = s_apply_Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
        var _S828 : bool = is_rough_0(_S776.value0_40.value0_39);
        if(_S828)
        {
            var _S829 : Tuple_11 = s_apply_facets_of_0(_S776.value0_40.value0_39, _S776.value0_40.value1_10);
            var _S830 : s_paramCtx_s_bwdCallableCtx_facets_of_0;
            _S830.value0_41 = _S776.value0_40.value1_10;
            var _S831 : Tuple_12 = s_apply_mirrored_0(_S829.value0_26, _S776.value0_40.value2_2, _S776.value0_40.value3_1);
            var _S832 : s_paramCtx_s_bwdCallableCtx_mirrored_0;
            _S832.value0_42 = _S829.value0_26;
            _S832.value1_12 = _S776.value0_40.value2_2;
            _S832.value2_3 = _S776.value0_40.value3_1;
            by_facets_1 = _S831.value0_27;
            _S807.value0_48 = _S832;
            _S808.value0_49 = _S830;
        }
        else
        {
            by_facets_1 = _S827.value0_25;
            _S807.value0_48 = _S786;
            _S808.value0_49 = _S784;
        }
        var _S833 : bool = (_S776.value0_40.value0_39.kind_0) == u32(2);
        if(_S833)
        {
            var _S834 : Tuple_16 = s_apply_fresnel_conductor_0(by_facets_1.cosine_0, _S776.value0_40.value1_10.eta_0, _S776.value0_40.value1_10.k_0);
            var _S835 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0;
            _S835.value0_43 = by_facets_1.cosine_0;
            _S835.value1_13 = _S776.value0_40.value1_10.eta_0;
            _S835.value2_4 = _S776.value0_40.value1_10.k_0;
            var _S836 : vec3<f32> = vec3<f32>(by_facets_1.scattered_0);
            var _S837 : vec3<f32> = _S834.value0_31 * _S836;
            _runFlag_5 = false;
            _S800 = _S776.value0_40.value1_10.specular_reflectance_0;
            _S801 = _S837;
            _S802 = _S834.value0_31;
            _S803 = _S836;
            _S812.value0_50 = _S835;
        }
        else
        {
            _runFlag_5 = _S799;
            _S800 = _S781;
            _S801 = _S781;
            _S802 = _S781;
            _S803 = _S781;
            _S812.value0_50 = _S787;
        }
        if(_runFlag_5)
        {
            var _S838 : Tuple_18 = s_apply_coat_eta_0(_S776.value0_40.value1_10);
            var _S839 : s_paramCtx_s_bwdCallableCtx_coat_eta_0;
            _S839.value0_44 = _S776.value0_40.value1_10;
            var _S840 : s_paramCtx_s_bwdCallableCtx_coat_eta_0 = _S839;
            var _S841 : f32 = _S776.value0_40.value2_2.z;
            var _S842 : s_paramCtx_s_bwdCallableCtx_transmittance_0;
            _S842.value0_45 = _S776.value0_40.value0_39;
            _S842.value1_14 = _S838.value0_33;
            _S842.value2_5 = _S841;
            var _S843 : s_paramCtx_s_bwdCallableCtx_transmittance_0 = _S842;
            var _S844 : s_paramCtx_s_bwdCallableCtx_transmittance_0;
            _S844.value0_45 = _S776.value0_40.value0_39;
            _S844.value1_14 = _S838.value0_33;
            _S844.value2_5 = _S795;
            var _S845 : s_paramCtx_s_bwdCallableCtx_transmittance_0 = _S844;
            var _S846 : s_paramCtx_s_bwdCallableCtx_base_0;
            _S846.value0_46 = _S776.value0_40.value0_39;
            _S846.value1_15 = _S838.value0_33;
            _S846.value2_6 = _S776.value0_40.value1_10.diffuse_reflectance_0;
            var _S847 : s_paramCtx_s_bwdCallableCtx_base_0 = _S846;
            var _S848 : f32 = _S776.value1_11.value0_23 * _S776.value1_11.value2_1;
            var _S849 : f32 = _S848 * by_cosine_1;
            var _S850 : f32 = _S838.value0_33 * _S838.value0_33;
            var _S851 : vec3<f32> = vec3<f32>((_S849 / _S850));
            var _S852 : f32 = _S850 * _S850;
            var probability_1 : f32 = base_probability_0(_S776.value0_40.value1_10, _S776.value1_11.value0_23);
            var _S853 : bool = (_S776.value0_40.value0_39.kind_0) == u32(4);
            if(_S853)
            {
                var _S854 : Tuple_21 = s_apply_fresnel_dielectric_0(by_facets_1.cosine_0, _S838.value0_33);
                var _S855 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0;
                _S855.value0_47 = by_facets_1.cosine_0;
                _S855.value1_16 = _S838.value0_33;
                var _S856 : vec3<f32> = vec3<f32>((_S854.value0_36 * by_facets_1.scattered_0));
                _S813 = 1.0f - probability_1;
                _S804 = _S776.value0_40.value1_10.specular_reflectance_0;
                _S805 = _S856;
                _S814 = _S854.value0_36;
                _S815 = by_facets_1.scattered_0;
                _S822.value0_51 = _S855;
            }
            else
            {
                _S813 = 0.0f;
                _S804 = _S781;
                _S805 = _S781;
                _S814 = 0.0f;
                _S815 = 0.0f;
                _S822.value0_51 = _S794;
            }
            _S809 = _S853;
            _S816 = probability_1;
            _S806 = _S851;
            _S817 = _S852;
            _S818 = _S849;
            _S819 = _S850;
            _S820 = _S838.value0_33;
            _S821 = _S848;
            _S823.value0_52 = _S847;
            _S823.value1_17 = _S776.value1_11.value5_0;
            _S824.value0_53 = _S845;
            _S824.value1_18 = _S776.value1_11.value3_0;
            _S825.value0_53 = _S843;
            _S825.value1_18 = _S776.value1_11.value1_6;
            _S826.value0_54 = _S840;
        }
        else
        {
            _S809 = false;
            _S813 = 0.0f;
            _S804 = _S781;
            _S805 = _S781;
            _S814 = 0.0f;
            _S815 = 0.0f;
            _S822.value0_51 = _S794;
            _S816 = 0.0f;
            _S806 = _S781;
            _S817 = 0.0f;
            _S818 = 0.0f;
            _S819 = 0.0f;
            _S820 = 0.0f;
            _S821 = 0.0f;
            _S823.value0_52 = _S792;
            _S823.value1_17 = _S793;
            _S824.value0_53 = _S790;
            _S824.value1_18 = _S791;
            _S825.value0_53 = _S790;
            _S825.value1_18 = _S791;
            _S826.value0_54 = _S788;
        }
        var _S857 : vec3<f32> = _S800;
        var _S858 : vec3<f32> = _S801;
        var _S859 : vec3<f32> = _S802;
        var _S860 : vec3<f32> = _S803;
        _S800 = _S804;
        _S801 = _S805;
        _S802 = _S806;
        _S810 = _S833;
        _S803 = _S857;
        _S804 = _S858;
        _S805 = _S859;
        _S806 = _S860;
        _S811 = _S828;
    }
    else
    {
        _runFlag_5 = false;
        _S809 = false;
        _S813 = 0.0f;
        _S800 = _S781;
        _S801 = _S781;
        _S814 = 0.0f;
        _S815 = 0.0f;
        _S822.value0_51 = _S794;
        _S816 = 0.0f;
        _S802 = _S781;
        _S817 = 0.0f;
        _S818 = 0.0f;
        _S819 = 0.0f;
        _S820 = 0.0f;
        _S821 = 0.0f;
        _S823.value0_52 = _S792;
        _S823.value1_17 = _S793;
        _S824.value0_53 = _S790;
        _S824.value1_18 = _S791;
        _S825.value0_53 = _S790;
        _S825.value1_18 = _S791;
        _S826.value0_54 = _S788;
        _S810 = false;
        _S803 = _S781;
        _S804 = _S781;
        _S805 = _S781;
        _S806 = _S781;
        _S812.value0_50 = _S787;
        _S811 = false;
        _S807.value0_48 = _S786;
        _S808.value0_49 = _S784;
    }
    var _S861 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S862 : Mirrored_0 = Mirrored_x24_syn_dzero_0();
    var _S863 : Scattering_Differential_0 = Scattering_x24_syn_dzero_0();
    var _S864 : Scattering_Differential_0 = Scattering_x24_syn_dadd_0(_S780, _S863);
    var _S865 : Scattering_Differential_0;
    var _S866 : Numbers_0;
    if(_S799)
    {
        if(_runFlag_5)
        {
            if(_S809)
            {
                var _S867 : f32 = _S813 * 0.0f;
                var _S868 : vec3<f32> = _S800 * _S864.value_0;
                var _S869 : vec3<f32> = _S801 * _S864.value_0;
                var _S870 : f32 = _S868[i32(0)] + _S868[i32(1)] + _S868[i32(2)];
                var _S871 : f32 = _S814 * _S870;
                var _S872 : f32 = _S815 * _S870;
                var _S873 : f32 = 0.0f;
                var _S874 : f32 = 0.0f;
                s_bwdProp_fresnel_dielectric_0(_S822, &(_S873), &(_S874), _S872);
                var _S875 : Mirrored_0 = _S862;
                _S875.pdf_1 = _S867;
                _S875.scattered_0 = _S871;
                _S875.cosine_0 = _S873;
                var _S876 : Mirrored_0 = Mirrored_x24_syn_dadd_0(_S862, _S875);
                var _S877 : Numbers_0 = _S861;
                _S877.specular_reflectance_0 = _S869;
                var _S878 : Numbers_0 = Numbers_x24_syn_dadd_0(_S861, _S877);
                _S865 = _S863;
                _S800 = _S864.value_0;
                _S813 = _S874;
                _S866 = _S878;
                by_facets_1 = _S876;
            }
            else
            {
                _S865 = Scattering_x24_syn_dadd_0(_S864, _S863);
                _S800 = _S781;
                _S813 = 0.0f;
                _S866 = _S861;
                by_facets_1 = _S862;
            }
            var _S879 : f32 = _S816 * 0.0f;
            var _S880 : vec3<f32> = _S865.value_0 + _S800;
            var _S881 : vec3<f32> = _S776.value1_11.value4_0 * _S880;
            var _S882 : vec3<f32> = _S802 * _S880;
            var _S883 : f32 = (_S881[i32(0)] + _S881[i32(1)] + _S881[i32(2)]) / _S817;
            var _S884 : f32 = _S819 * _S883;
            var _S885 : f32 = _S820 * (_S818 * - _S883);
            var _S886 : f32 = _S821 * _S884;
            var _S887 : f32 = by_cosine_1 * _S884;
            var _S888 : f32 = _S776.value1_11.value0_23 * _S887;
            var _S889 : f32 = _S776.value1_11.value2_1 * _S887;
            var _S890 : f32 = 0.0f;
            var _S891 : vec3<f32> = _S781;
            s_bwdProp_base_0(_S823, &(_S890), &(_S891), _S882);
            var _S892 : f32 = 0.0f;
            var _S893 : f32 = 0.0f;
            s_bwdProp_transmittance_0(_S824, &(_S892), &(_S893), _S888);
            var _S894 : f32 = 0.0f;
            var _S895 : f32 = 0.0f;
            s_bwdProp_transmittance_0(_S825, &(_S894), &(_S895), _S889);
            var _S896 : f32 = _S885 + _S885 + _S890 + _S892 + _S894 + _S813;
            var _S897 : Numbers_0;
            _S897.diffuse_reflectance_0 = _S781;
            _S897.specular_reflectance_0 = _S781;
            _S897.eta_0 = _S781;
            _S897.k_0 = _S781;
            _S897.alpha_0 = _S782;
            s_bwdProp_coat_eta_0(_S826, &(_S897), _S896);
            var _S898 : f32 = _S879 + _S886;
            var _S899 : vec3<f32> = vec3<f32>(0.0f, 0.0f, _S895);
            var _S900 : Numbers_0 = Numbers_x24_syn_dadd_0(_S897, _S866);
            var _S901 : Numbers_0 = _S861;
            _S901.diffuse_reflectance_0 = _S891;
            var _S902 : Numbers_0 = Numbers_x24_syn_dadd_0(_S900, _S901);
            _S865 = _S863;
            _S866 = _S902;
            _S800 = _S899;
            _S813 = _S898;
            _S814 = _S893;
        }
        else
        {
            _S865 = Scattering_x24_syn_dadd_0(_S864, _S863);
            by_facets_1 = _S862;
            _S866 = _S861;
            _S800 = _S781;
            _S813 = 0.0f;
            _S814 = 0.0f;
        }
        if(_S810)
        {
            var _S903 : vec3<f32> = _S803 * _S865.value_0;
            var _S904 : vec3<f32> = _S804 * _S865.value_0;
            var _S905 : vec3<f32> = _S805 * _S903;
            var _S906 : vec3<f32> = _S806 * _S903;
            var _S907 : f32 = _S905[i32(0)] + _S905[i32(1)] + _S905[i32(2)];
            var _S908 : f32 = 0.0f;
            var _S909 : vec3<f32> = _S781;
            var _S910 : vec3<f32> = _S781;
            s_bwdProp_fresnel_conductor_0(_S812, &(_S908), &(_S909), &(_S910), _S906);
            var _S911 : Mirrored_0 = _S862;
            _S911.pdf_1 = 0.0f;
            _S911.scattered_0 = _S907;
            _S911.cosine_0 = _S908;
            var _S912 : Mirrored_0 = Mirrored_x24_syn_dadd_0(by_facets_1, _S911);
            var _S913 : Numbers_0 = _S861;
            _S913.specular_reflectance_0 = _S904;
            _S913.k_0 = _S910;
            _S913.eta_0 = _S909;
            var _S914 : Numbers_0 = Numbers_x24_syn_dadd_0(_S866, _S913);
            by_facets_1 = _S912;
            _S866 = _S914;
            _S865 = _S863;
        }
        else
        {
            _S865 = Scattering_x24_syn_dadd_0(_S865, _S863);
        }
        if(_S811)
        {
            var _S915 : Microfacets_Differential_0;
            _S915.alpha_2 = _S782;
            var _S916 : vec3<f32> = _S781;
            var _S917 : vec3<f32> = _S781;
            s_bwdProp_mirrored_0(_S807, &(_S915), &(_S916), &(_S917), by_facets_1);
            var _S918 : Numbers_0;
            _S918.diffuse_reflectance_0 = _S781;
            _S918.specular_reflectance_0 = _S781;
            _S918.eta_0 = _S781;
            _S918.k_0 = _S781;
            _S918.alpha_0 = _S782;
            s_bwdProp_facets_of_0(_S808, &(_S918), _S915);
            var _S919 : vec3<f32> = _S916 + _S800;
            _S866 = Numbers_x24_syn_dadd_0(_S918, _S866);
            _S800 = _S917;
            _S801 = _S919;
        }
        else
        {
            var _S920 : vec3<f32> = _S800;
            _S800 = _S781;
            _S801 = _S920;
        }
    }
    else
    {
        _S865 = Scattering_x24_syn_dadd_0(_S864, _S863);
        _S866 = _S861;
        _S813 = 0.0f;
        _S814 = 0.0f;
        _S800 = _S781;
        _S801 = _S781;
    }
    if(_S797)
    {
        var _S921 : vec3<f32> = _S798 * _S865.value_0;
        var _S922 : vec3<f32> = _S796 * _S865.value_0;
        var _S923 : Numbers_0 = _S861;
        _S923.diffuse_reflectance_0 = _S922;
        var _S924 : Numbers_0 = Numbers_x24_syn_dadd_0(_S866, _S923);
        _S798 = _S921;
        _S866 = _S924;
    }
    else
    {
        _S798 = _S781;
    }
    var _S925 : vec3<f32> = _S800 + vec3<f32>(0.0f, 0.0f, 0.31830987334251404f * (_S798[i32(0)] + _S798[i32(1)] + _S798[i32(2)] + _S813) + _S814);
    (*_S777) = _S866;
    (*_S778) = _S801;
    (*_S779) = _S925;
    return;
}

fn _S926( _S927 : Lobe_0,  _S928 : ptr<function, DiffPair_Numbers_0>,  _S929 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S930 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S931 : Scattering_Differential_0)
{
    var _S932 : Tuple_9 = s_apply_scattering_0(_S927, (*_S928).primal_0, (*_S929).primal_0, (*_S930).primal_0);
    var _S933 : s_paramCtx_s_bwdCallableCtx_scattering_0;
    _S933.value0_39 = _S927;
    _S933.value1_10 = (*_S928).primal_0;
    _S933.value2_2 = (*_S929).primal_0;
    _S933.value3_1 = (*_S930).primal_0;
    var _S934 : s_bwdCallableCtx_scattering_0 = s_bwdCallableCtx_scattering_0( _S933, _S932.value1_7 );
    var _S935 : Numbers_0 = (*_S928).differential_0;
    var _S936 : vec3<f32> = (*_S929).differential_0;
    var _S937 : vec3<f32> = (*_S930).differential_0;
    s_bwdProp_scattering_0(_S934, &(_S935), &(_S936), &(_S937), _S931);
    (*_S928).differential_0 = _S935;
    (*_S929).differential_0 = _S936;
    (*_S930).differential_0 = _S937;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_specular_fraction_0
{
     value0_67 : Lobe_0,
     value1_22 : Numbers_0,
     value2_8 : vec3<f32>,
};

struct s_bwdCallableCtx_specular_fraction_0
{
     value0_68 : s_paramCtx_s_bwdCallableCtx_specular_fraction_0,
};

fn s_bwdProp_specular_fraction_0( _S938 : s_bwdCallableCtx_specular_fraction_0,  _S939 : ptr<function, Numbers_0>,  _S940 : ptr<function, vec3<f32>>,  _S941 : vec3<f32>)
{
    var _S942 : vec3<f32> = vec3<f32>(0.0f);
    var _S943 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0 = s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0( 0.0f, _S942, _S942 );
    var _S944 : vec2<f32> = vec2<f32>(0.0f);
    var _S945 : Numbers_0 = Numbers_0( _S942, _S942, _S942, _S942, _S944 );
    var _S946 : s_paramCtx_s_bwdCallableCtx_coat_eta_0 = s_paramCtx_s_bwdCallableCtx_coat_eta_0( _S945 );
    var _S947 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0 = s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0( 0.0f, 0.0f );
    var _S948 : bool = (_S938.value0_68.value0_67.kind_0) == u32(1);
    var _S949 : vec3<f32>;
    var _S950 : vec3<f32>;
    var _S951 : s_bwdCallableCtx_fresnel_conductor_0;
    if(_S948)
    {
        var _S952 : f32 = _S938.value0_68.value2_8.z;
        var _S953 : Tuple_16 = s_apply_fresnel_conductor_0(_S952, _S938.value0_68.value1_22.eta_0, _S938.value0_68.value1_22.k_0);
        var _S954 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0;
        _S954.value0_43 = _S952;
        _S954.value1_13 = _S938.value0_68.value1_22.eta_0;
        _S954.value2_4 = _S938.value0_68.value1_22.k_0;
        _S949 = _S938.value0_68.value1_22.specular_reflectance_0;
        _S950 = _S953.value0_31;
        _S951.value0_50 = _S954;
    }
    else
    {
        _S949 = _S942;
        _S950 = _S942;
        _S951.value0_50 = _S943;
    }
    var _S955 : bool = !_S948;
    var _S956 : vec3<f32>;
    var _S957 : vec3<f32>;
    var _S958 : s_bwdCallableCtx_fresnel_dielectric_0;
    var _S959 : s_bwdCallableCtx_coat_eta_0;
    if(_S955)
    {
        var _S960 : f32 = _S938.value0_68.value2_8.z;
        var _S961 : Tuple_18 = s_apply_coat_eta_0(_S938.value0_68.value1_22);
        var _S962 : s_paramCtx_s_bwdCallableCtx_coat_eta_0;
        _S962.value0_44 = _S938.value0_68.value1_22;
        var _S963 : vec3<f32> = vec3<f32>(s_apply_fresnel_dielectric_0(_S960, _S961.value0_33).value0_36);
        var _S964 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0;
        _S964.value0_47 = _S960;
        _S964.value1_16 = _S961.value0_33;
        _S956 = _S938.value0_68.value1_22.specular_reflectance_0;
        _S957 = _S963;
        _S958.value0_51 = _S964;
        _S959.value0_54 = _S962;
    }
    else
    {
        _S956 = _S942;
        _S957 = _S942;
        _S958.value0_51 = _S947;
        _S959.value0_54 = _S946;
    }
    var _S965 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S966 : Numbers_0;
    if(_S955)
    {
        var _S967 : vec3<f32> = _S956 * _S941;
        var _S968 : vec3<f32> = _S957 * _S941;
        var _S969 : f32 = _S967[i32(0)] + _S967[i32(1)] + _S967[i32(2)];
        var _S970 : f32 = 0.0f;
        var _S971 : f32 = 0.0f;
        s_bwdProp_fresnel_dielectric_0(_S958, &(_S970), &(_S971), _S969);
        var _S972 : Numbers_0;
        _S972.diffuse_reflectance_0 = _S942;
        _S972.specular_reflectance_0 = _S942;
        _S972.eta_0 = _S942;
        _S972.k_0 = _S942;
        _S972.alpha_0 = _S944;
        s_bwdProp_coat_eta_0(_S959, &(_S972), _S971);
        var _S973 : vec3<f32> = vec3<f32>(0.0f, 0.0f, _S970);
        var _S974 : Numbers_0 = Numbers_x24_syn_dadd_0(_S972, _S965);
        var _S975 : Numbers_0 = _S965;
        _S975.specular_reflectance_0 = _S968;
        var _S976 : Numbers_0 = Numbers_x24_syn_dadd_0(_S974, _S975);
        _S956 = _S942;
        _S957 = _S973;
        _S966 = _S976;
    }
    else
    {
        _S956 = _S941;
        _S957 = _S942;
        _S966 = _S965;
    }
    if(_S948)
    {
        var _S977 : vec3<f32> = _S949 * _S956;
        var _S978 : vec3<f32> = _S950 * _S956;
        var _S979 : f32 = 0.0f;
        var _S980 : vec3<f32> = _S942;
        var _S981 : vec3<f32> = _S942;
        s_bwdProp_fresnel_conductor_0(_S951, &(_S979), &(_S980), &(_S981), _S977);
        var _S982 : vec3<f32> = _S957 + vec3<f32>(0.0f, 0.0f, _S979);
        var _S983 : Numbers_0 = _S965;
        _S983.k_0 = _S981;
        _S983.eta_0 = _S980;
        _S983.specular_reflectance_0 = _S978;
        _S966 = Numbers_x24_syn_dadd_0(_S966, _S983);
        _S949 = _S982;
    }
    else
    {
        _S949 = _S957;
    }
    (*_S939) = _S966;
    (*_S940) = _S949;
    return;
}

fn _S984( _S985 : Lobe_0,  _S986 : ptr<function, DiffPair_Numbers_0>,  _S987 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S988 : vec3<f32>)
{
    var _S989 : s_paramCtx_s_bwdCallableCtx_specular_fraction_0;
    _S989.value0_67 = _S985;
    _S989.value1_22 = (*_S986).primal_0;
    _S989.value2_8 = (*_S987).primal_0;
    var _S990 : s_bwdCallableCtx_specular_fraction_0 = s_bwdCallableCtx_specular_fraction_0( _S989 );
    var _S991 : Numbers_0 = (*_S986).differential_0;
    var _S992 : vec3<f32> = (*_S987).differential_0;
    s_bwdProp_specular_fraction_0(_S990, &(_S991), &(_S992), _S988);
    (*_S986).differential_0 = _S991;
    (*_S987).differential_0 = _S992;
    return;
}

fn kept_at_0( depth_1 : u32) -> u32
{
    return u32(33) + u32(29) * depth_1;
}

fn path_word_0( path_0 : u32,  which_0 : u32) -> u32
{
    return paths_0[which_0 * launch_0.room_0 + path_0];
}

fn path_vector_0( path_1 : u32,  which_1 : ptr<function, u32>) -> vec3<f32>
{
    var _S993 : u32 = (*which_1) + u32(3);
    (*which_1) = _S993;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_1, _S993 - u32(3)), path_word_0(path_1, _S993 - u32(2)), path_word_0(path_1, _S993 - u32(1))))));
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
};

fn exact_place_0( triangle_1 : u32,  v_1 : f64,  w_1 : f64) -> Place_0
{
    var place_2 : Place_0;
    place_2.triangle_0 = triangle_1;
    var _S994 : f32 = f32(v_1);
    place_2.v_0 = _S994;
    var _S995 : f32 = f32(w_1);
    place_2.w_0 = _S995;
    place_2.v_rest_0 = f32(v_1 - f64(_S994));
    place_2.w_rest_0 = f32(w_1 - f64(_S995));
    return place_2;
}

fn path_place_0( path_2 : u32,  which_2 : ptr<function, u32>) -> Place_0
{
    var _S996 : u32 = (*which_2) + u32(5);
    (*which_2) = _S996;
    return exact_place_0(path_word_0(path_2, _S996 - u32(5)), f64((bitcast<f32>((path_word_0(path_2, _S996 - u32(4)))))) + f64((bitcast<f32>((path_word_0(path_2, _S996 - u32(2)))))), f64((bitcast<f32>((path_word_0(path_2, _S996 - u32(3)))))) + f64((bitcast<f32>((path_word_0(path_2, _S996 - u32(1)))))));
}

fn triangle_record_0( triangle_2 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_2;
}

fn shape_of_0( triangle_3 : u32) -> u32
{
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_3));
}

fn primitive_vector_0( at_3 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_0[at_3], primitives_0[at_3 + u32(1)], primitives_0[at_3 + u32(2)]);
}

fn position_of_0( place_3 : Place_0) -> vec3<f64>
{
    var at_4 : u32 = u32(9) * place_3.triangle_0;
    var a_4 : vec3<f64> = primitive_vector_0(at_4);
    return a_4 + (primitive_vector_0(at_4 + u32(3)) - a_4) * vec3<f64>((f64(place_3.v_0) + f64(place_3.v_rest_0))) + (primitive_vector_0(at_4 + u32(6)) - a_4) * vec3<f64>((f64(place_3.w_0) + f64(place_3.w_rest_0)));
}

fn cross_of_0( triangle_4 : u32) -> vec3<f32>
{
    var at_5 : u32 = u32(9) * triangle_4;
    var a_5 : vec3<f64> = primitive_vector_0(at_5);
    return cross(vec3<f32>(primitive_vector_0(at_5 + u32(3)) - a_5), vec3<f32>(primitive_vector_0(at_5 + u32(6)) - a_5));
}

fn unit_0( v_2 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_2 / vec3<f32>(max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z))));
}

fn vector_at_0( at_6 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_6), number_0(at_6 + u32(1)), number_0(at_6 + u32(2)));
}

struct Surface_0
{
     place_4 : Place_0,
     shape_0 : u32,
     exact_0 : vec3<f64>,
     position_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     outward_0 : vec3<f32>,
     is_front_0 : bool,
};

fn surface_at_0( place_5 : Place_0,  direction_0 : vec3<f32>) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.place_4 = place_5;
    surface_0.shape_0 = shape_of_0(place_5.triangle_0);
    var _S997 : vec3<f64> = position_of_0(place_5);
    surface_0.exact_0 = _S997;
    surface_0.position_0 = vec3<f32>(_S997);
    var _S998 : vec3<f32> = unit_0(cross_of_0(place_5.triangle_0));
    surface_0.face_normal_0 = _S998;
    surface_0.outward_0 = _S998;
    var seen_0 : f32;
    if((dot(_S998, direction_0)) > 0.0f)
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
        var record_1 : u32 = triangle_record_0(place_5.triangle_0) + u32(2);
        var a_6 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_1));
        var b_3 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_1 + u32(1)));
        var c_0 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_1 + u32(2)));
        if((dot(a_6 + b_3 + c_0, surface_0.face_normal_0)) < 0.0f)
        {
            seen_0 = - seen_0;
        }
        surface_0.outward_0 = normalize(a_6 + (b_3 - a_6) * vec3<f32>(place_5.v_0) + (c_0 - a_6) * vec3<f32>(place_5.w_0));
    }
    surface_0.is_front_0 = seen_0 > 0.0f;
    return surface_0;
}

fn material_of_0( surface_1 : Surface_0) -> u32
{
    var _S999 : u32;
    if(surface_1.is_front_0)
    {
        _S999 = u32(2);
    }
    else
    {
        _S999 = u32(3);
    }
    return word_0(surface_1.shape_0 + _S999);
}

fn no_numbers_0() -> Numbers_0
{
    var numbers_2 : Numbers_0;
    var _S1000 : vec3<f32> = vec3<f32>(0.0f);
    numbers_2.k_0 = _S1000;
    numbers_2.eta_0 = _S1000;
    numbers_2.specular_reflectance_0 = _S1000;
    numbers_2.diffuse_reflectance_0 = _S1000;
    numbers_2.alpha_0 = vec2<f32>(0.0f);
    return numbers_2;
}

struct Lookup_0
{
     count_0 : u32,
     texels_0 : vec4<u32>,
     weights_1 : vec4<f32>,
     by_first_0 : vec4<f32>,
     by_second_0 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_1 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    var _S1001 : vec4<f32> = vec4<f32>(0.0f);
    lookup_0.by_second_0 = _S1001;
    lookup_0.by_first_0 = _S1001;
    return lookup_0;
}

struct Corners2_0
{
     a_7 : vec2<f64>,
     b_4 : vec2<f64>,
     c_1 : vec2<f64>,
};

fn Corners2_x24init_0( a_8 : vec2<f64>,  b_5 : vec2<f64>,  c_2 : vec2<f64>) -> Corners2_0
{
    var _S1002 : Corners2_0;
    _S1002.a_7 = a_8;
    _S1002.b_4 = b_5;
    _S1002.c_1 = c_2;
    return _S1002;
}

fn precise_0( at_7 : u32) -> f64
{
    return f64(number_0(at_7)) + f64(number_0(at_7 + u32(1)));
}

fn uvs_of_0( triangle_5 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f64>(0.0lf, 0.0lf), vec2<f64>(1.0lf, 0.0lf), vec2<f64>(0.0lf, 1.0lf));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_5) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_8 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_5) + u32(1));
    uvs_0.a_7 = vec2<f64>(precise_0(at_8), precise_0(at_8 + u32(2)));
    uvs_0.b_4 = vec2<f64>(precise_0(at_8 + u32(4)), precise_0(at_8 + u32(6)));
    uvs_0.c_1 = vec2<f64>(precise_0(at_8 + u32(8)), precise_0(at_8 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_9 : u32) -> vec3<f64>
{
    return vec3<f64>(precise_0(at_9), precise_0(at_9 + u32(2)), precise_0(at_9 + u32(4)));
}

fn floor_of_0( x_11 : f64) -> i32
{
    return i32(clamp(f32(floor(x_11)), -1.0e+09f, 1.0e+09f));
}

fn wrapped_0( i_0 : i32,  n_1 : i32,  wrap_0 : u32) -> u32
{
    if(wrap_0 == u32(2))
    {
        return u32(clamp(i_0, i32(0), n_1 - i32(1)));
    }
    var period_0 : i32;
    if(wrap_0 == u32(1))
    {
        period_0 = i32(2) * n_1;
    }
    else
    {
        period_0 = n_1;
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
    if(inside_1 < n_1)
    {
        period_0 = inside_1;
    }
    else
    {
        period_0 = i32(2) * n_1 - i32(1) - inside_1;
    }
    return u32(period_0);
}

struct Point_0
{
     value_2 : vec2<f64>,
     by_first_1 : vec2<f32>,
     by_second_1 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_6 : Point_0) -> Lookup_0
{
    var _S1003 : vec2<f32> = vec2<f32>(place_6.value_2 - floor(place_6.value_2));
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - _S1003;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S1004 : f32 = back_0.x;
    var _S1005 : f32 = back_0.y;
    var _S1006 : f32 = _S1003.x;
    var _S1007 : f32 = _S1003.y;
    lookup_1.weights_1 = vec4<f32>(_S1004 * _S1005, _S1006 * _S1005, _S1004 * _S1007, _S1006 * _S1007);
    var by_x_0 : vec4<f32> = vec4<f32>(- _S1005, _S1005, - _S1007, _S1007);
    var by_y_0 : vec4<f32> = vec4<f32>(- _S1004, - _S1006, _S1004, _S1006);
    lookup_1.by_first_0 = by_x_0 * vec4<f32>(place_6.by_first_1.x) + by_y_0 * vec4<f32>(place_6.by_first_1.y);
    lookup_1.by_second_0 = by_x_0 * vec4<f32>(place_6.by_second_1.x) + by_y_0 * vec4<f32>(place_6.by_second_1.y);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var size_0 : vec2<f32> = vec2<f32>(f32(width_0), f32(height_0));
    var place_7 : vec2<f64> = uv_0.value_2 * vec2<f64>(size_0);
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_7.y), height_0, wrap_1);
        var _S1008 : u32 = row_0 * u32(width_0);
        var _S1009 : u32 = wrapped_0(floor_of_0(place_7.x), width_0, wrap_1);
        return one_texel_0(_S1008 + _S1009);
    }
    var centred_0 : Point_0;
    var _S1010 : vec2<f64> = place_7 - vec2<f64>(0.5lf);
    centred_0.value_2 = _S1010;
    centred_0.by_first_1 = uv_0.by_first_1 * size_0;
    centred_0.by_second_1 = uv_0.by_second_1 * size_0;
    var x_12 : i32 = floor_of_0(_S1010.x);
    var y_3 : i32 = floor_of_0(_S1010.y);
    var _S1011 : u32 = wrapped_0(y_3, height_0, wrap_1);
    var _S1012 : u32 = u32(width_0);
    var first_1 : u32 = _S1011 * _S1012;
    var _S1013 : u32 = wrapped_0(y_3 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S1013 * _S1012;
    var left_0 : u32 = wrapped_0(x_12, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_12 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_8 : Place_0) -> Lookup_0
{
    var kind_1 : u32 = word_0(texture_1);
    if(kind_1 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_2 : u32 = triangle_record_0(place_8.triangle_0) + u32(1);
    if(kind_1 == u32(4))
    {
        return one_texel_0(word_0(record_2));
    }
    if(kind_1 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_2 + u32(1)), word_0(record_2 + u32(2)), word_0(record_2 + u32(3)), u32(0));
        lookup_2.weights_1 = vec4<f32>(1.0f - place_8.v_0 - place_8.w_0, place_8.v_0, place_8.w_0, 0.0f);
        lookup_2.by_first_0 = vec4<f32>(-1.0f, 1.0f, 0.0f, 0.0f);
        lookup_2.by_second_0 = vec4<f32>(-1.0f, 0.0f, 1.0f, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_8.triangle_0);
    var by_v_0 : vec2<f64> = uvs_1.b_4 - uvs_1.a_7;
    var by_w_0 : vec2<f64> = uvs_1.c_1 - uvs_1.a_7;
    var _S1014 : u32 = texture_1 + u32(6);
    var to_u_0 : vec3<f64> = row_at_0(_S1014);
    var to_v_0 : vec3<f64> = row_at_0(_S1014 + u32(6));
    var uv_1 : Point_0;
    var _S1015 : vec3<f64> = vec3<f64>(uvs_1.a_7 + by_v_0 * vec2<f64>((f64(place_8.v_0) + f64(place_8.v_rest_0))) + by_w_0 * vec2<f64>((f64(place_8.w_0) + f64(place_8.w_rest_0))), 1.0lf);
    uv_1.value_2 = vec2<f64>(dot(_S1015, to_u_0), dot(_S1015, to_v_0));
    var _S1016 : vec2<f64> = to_u_0.xy;
    var _S1017 : vec2<f64> = to_v_0.xy;
    uv_1.by_first_1 = vec2<f32>(vec2<f64>(dot(by_v_0, _S1016), dot(by_v_0, _S1017)));
    uv_1.by_second_1 = vec2<f32>(vec2<f64>(dot(by_w_0, _S1016), dot(by_w_0, _S1017)));
    if(kind_1 == u32(1))
    {
        var _S1018 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S1018;
    }
    var half_of_period_0 : vec2<f64> = uv_1.value_2 - floor(uv_1.value_2);
    var _S1019 : i32;
    if(((half_of_period_0.x) > 0.5lf) != ((half_of_period_0.y) > 0.5lf))
    {
        _S1019 = i32(1);
    }
    else
    {
        _S1019 = i32(0);
    }
    return one_texel_0(u32(_S1019));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_2 : vec4<f32>) -> vec3<f32>
{
    var _S1020 : u32 = word_0(texture_2 + u32(1));
    var _S1021 : u32 = texture_2 + u32(19);
    var _S1022 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_3 : vec3<f32> = _S1022;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_10 : u32 = _S1021 + _S1020 * lookup_3.texels_0[k_1];
        var _S1023 : vec3<f32>;
        if(_S1020 == u32(1))
        {
            _S1023 = vec3<f32>(number_0(at_10));
        }
        else
        {
            _S1023 = vector_at_0(at_10);
        }
        var value_4 : vec3<f32> = value_3 + _S1023 * vec3<f32>(weights_2[k_1]);
        k_1 = k_1 + u32(1);
        value_3 = value_4;
    }
    return value_3;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_1);
}

fn shown_0( texture_4 : u32,  place_9 : Place_0) -> vec3<f32>
{
    var _S1024 : Lookup_0 = lookup_at_0(texture_4, place_9);
    return looked_up_0(texture_4, _S1024, vec2<f32>(0.0f));
}

fn value_of_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0;
}

fn luminance_0( colour_1 : vec3<f32>) -> f32
{
    return dot(colour_1, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f));
}

fn set_slot_0( numbers_3 : ptr<function, Numbers_0>,  slot_0 : u32,  value_5 : vec3<f32>)
{
    switch(slot_0)
    {
    case u32(0):
        {
            (*numbers_3).diffuse_reflectance_0 = value_5;
            break;
        }
    case u32(1):
        {
            (*numbers_3).specular_reflectance_0 = value_5;
            break;
        }
    case u32(2):
        {
            (*numbers_3).eta_0 = value_5;
            break;
        }
    case u32(3):
        {
            (*numbers_3).k_0 = value_5;
            break;
        }
    case u32(4):
        {
            (*numbers_3).alpha_0[i32(0)] = luminance_0(value_5);
            break;
        }
    default :
        {
            (*numbers_3).alpha_0[i32(1)] = luminance_0(value_5);
            break;
        }
    }
    return;
}

fn lobe_at_0( record_3 : u32,  place_10 : Place_0) -> Lobe_0
{
    var lobe_5 : Lobe_0;
    lobe_5.record_0 = record_3;
    var is_black_0 : bool = record_3 == u32(4294967295);
    var _S1025 : u32;
    if(is_black_0)
    {
        _S1025 = u32(0);
    }
    else
    {
        _S1025 = word_0(record_3);
    }
    lobe_5.kind_0 = _S1025;
    if(is_black_0)
    {
        _S1025 = u32(1);
    }
    else
    {
        _S1025 = word_0(record_3 + u32(1));
    }
    lobe_5.distribution_0 = _S1025;
    lobe_5.numbers_0 = no_numbers_0();
    if(is_black_0)
    {
        _S1025 = u32(0);
    }
    else
    {
        _S1025 = word_0(record_3 + u32(4));
    }
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < _S1025)
        {
        }
        else
        {
            break;
        }
        var texture_5 : u32 = word_0(record_3 + u32(5) + slot_1);
        if(texture_5 == u32(4294967295))
        {
            slot_1 = slot_1 + u32(1);
            continue;
        }
        var colour_2 : vec3<f32> = shown_0(texture_5, place_10);
        var _S1026 : vec3<f32> = value_of_0(colour_2);
        var _S1027 : Numbers_0 = lobe_5.numbers_0;
        set_slot_0(&(_S1027), slot_1, _S1026);
        lobe_5.numbers_0 = _S1027;
        slot_1 = slot_1 + u32(1);
    }
    return lobe_5;
}

fn tangent_at_0( surface_2 : Surface_0) -> vec3<f32>
{
    var tangents_0 : u32 = word_0(surface_2.shape_0 + u32(5));
    if(tangents_0 == u32(4294967295))
    {
        return vec3<f32>(0.0f);
    }
    var tangent_0 : vec3<f32> = vector_at_0(tangents_0 + u32(3) * word_0(triangle_record_0(surface_2.place_4.triangle_0) + u32(1)));
    var across_0 : vec3<f32> = cross(tangent_0, surface_2.outward_0);
    var _S1028 : vec3<f32>;
    if((dot(across_0, across_0)) > 0.0f)
    {
        _S1028 = tangent_0;
    }
    else
    {
        _S1028 = vec3<f32>(0.0f);
    }
    return _S1028;
}

fn axes_along_0( n_2 : vec3<f32>,  tangent_1 : vec3<f32>,  is_front_1 : bool) -> Axes_0
{
    var axes_0 : Axes_0;
    var _S1029 : vec3<f32>;
    if(is_front_1)
    {
        _S1029 = n_2;
    }
    else
    {
        _S1029 = (vec3<f32>(0) - n_2);
    }
    axes_0.n_0 = _S1029;
    var _S1030 : vec3<f32> = normalize(tangent_1 - n_2 * vec3<f32>(dot(n_2, tangent_1)));
    axes_0.s_0 = _S1030;
    axes_0.t_0 = cross(n_2, _S1030);
    return axes_0;
}

fn axes_around_0( n_3 : vec3<f32>,  is_front_2 : bool) -> Axes_0
{
    var axes_1 : Axes_0;
    var _S1031 : vec3<f32>;
    if(is_front_2)
    {
        _S1031 = n_3;
    }
    else
    {
        _S1031 = (vec3<f32>(0) - n_3);
    }
    axes_1.n_0 = _S1031;
    var _S1032 : f32 = n_3.z;
    var sign_1 : f32;
    if(_S1032 < -0.00000999999974738f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var a_9 : f32 = -1.0f / (sign_1 + _S1032);
    var _S1033 : f32 = n_3.x;
    var _S1034 : f32 = n_3.y;
    var b_6 : f32 = _S1033 * _S1034 * a_9;
    axes_1.s_0 = vec3<f32>(1.0f + sign_1 * _S1033 * _S1033 * a_9, sign_1 * b_6, - sign_1 * _S1033);
    axes_1.t_0 = vec3<f32>(b_6, sign_1 + _S1034 * _S1034 * a_9, - _S1034);
    return axes_1;
}

fn to_local_0( axes_2 : Axes_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(axes_2.s_0, v_3), dot(axes_2.t_0, v_3), dot(axes_2.n_0, v_3));
}

fn towards_viewer_0( axes_3 : Axes_0,  direction_1 : vec3<f32>) -> vec3<f32>
{
    var wi_0 : vec3<f32> = (vec3<f32>(0) - to_local_0(axes_3, direction_1));
    return vec3<f32>(wi_0.x, wi_0.y, max(abs(wi_0.z), 9.999999960041972e-13f));
}

struct Vertex_0
{
     surface_3 : Surface_0,
     axes_4 : Axes_0,
     lobe_6 : Lobe_0,
     wi_1 : vec3<f32>,
};

fn vertex_at_0( surface_4 : Surface_0,  material_0 : u32,  direction_2 : vec3<f32>) -> Vertex_0
{
    var vertex_0 : Vertex_0;
    vertex_0.surface_3 = surface_4;
    var _S1035 : Lobe_0 = lobe_at_0(material_0, surface_4.place_4);
    vertex_0.lobe_6 = _S1035;
    var tangent_2 : vec3<f32> = tangent_at_0(surface_4);
    if((any((tangent_2 != vec3<f32>(0.0f)))))
    {
        vertex_0.axes_4 = axes_along_0(surface_4.outward_0, tangent_2, surface_4.is_front_0);
    }
    else
    {
        vertex_0.axes_4 = axes_around_0(surface_4.outward_0, surface_4.is_front_0);
    }
    vertex_0.wi_1 = towards_viewer_0(vertex_0.axes_4, direction_2);
    return vertex_0;
}

struct Pulled_0
{
     numbers_4 : Numbers_0,
     axes_5 : Axes_0,
     wi_2 : vec3<f32>,
     position_1 : vec3<f32>,
};

fn nothing_pulled_0() -> Pulled_0
{
    var pulled_0 : Pulled_0;
    pulled_0.numbers_4 = no_numbers_0();
    var _S1036 : vec3<f32> = vec3<f32>(0.0f);
    pulled_0.position_1 = _S1036;
    pulled_0.wi_2 = _S1036;
    pulled_0.axes_5.n_0 = _S1036;
    pulled_0.axes_5.t_0 = _S1036;
    pulled_0.axes_5.s_0 = _S1036;
    return pulled_0;
}

fn to_world_0( axes_6 : Axes_0,  v_4 : vec3<f32>) -> vec3<f32>
{
    return axes_6.s_0 * vec3<f32>(v_4.x) + axes_6.t_0 * vec3<f32>(v_4.y) + axes_6.n_0 * vec3<f32>(v_4.z);
}

fn axes_back_0( axes_7 : ptr<function, Axes_0>,  local_0 : vec3<f32>,  world_0 : vec3<f32>)
{
    (*axes_7).s_0 = (*axes_7).s_0 + world_0 * vec3<f32>(local_0.x);
    (*axes_7).t_0 = (*axes_7).t_0 + world_0 * vec3<f32>(local_0.y);
    (*axes_7).n_0 = (*axes_7).n_0 + world_0 * vec3<f32>(local_0.z);
    return;
}

fn scattered_back_0( pulled_1 : ptr<function, Pulled_0>,  vertex_1 : Vertex_0,  wo_0 : vec3<f32>,  direction_3 : vec3<f32>,  is_specular_0 : bool,  by_value_0 : vec3<f32>) -> vec3<f32>
{
    var _S1037 : Numbers_0 = no_numbers_0();
    var numbers_5 : DiffPair_Numbers_0;
    numbers_5.primal_0 = vertex_1.lobe_6.numbers_0;
    numbers_5.differential_0 = _S1037;
    var _S1038 : vec3<f32> = vec3<f32>(0.0f);
    var wi_3 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    wi_3.primal_0 = vertex_1.wi_1;
    wi_3.differential_0 = _S1038;
    var onward_0 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    onward_0.primal_0 = wo_0;
    onward_0.differential_0 = _S1038;
    if(is_specular_0)
    {
        _S984(vertex_1.lobe_6, &(numbers_5), &(wi_3), by_value_0);
    }
    else
    {
        var by_scattering_0 : Scattering_Differential_0;
        by_scattering_0.value_0 = by_value_0;
        _S926(vertex_1.lobe_6, &(numbers_5), &(wi_3), &(onward_0), by_scattering_0);
        var _S1039 : Axes_0 = (*pulled_1).axes_5;
        axes_back_0(&(_S1039), onward_0.differential_0, direction_3);
        (*pulled_1).axes_5 = _S1039;
    }
    (*pulled_1).numbers_4 = Numbers_x24_syn_dadd_0((*pulled_1).numbers_4, numbers_5.differential_0);
    (*pulled_1).wi_2 = (*pulled_1).wi_2 + wi_3.differential_0;
    var _S1040 : vec3<f32>;
    if(is_specular_0)
    {
        _S1040 = _S1038;
    }
    else
    {
        _S1040 = to_world_0(vertex_1.axes_4, onward_0.differential_0);
    }
    return _S1040;
}

fn specular_direction_back_0( pulled_2 : ptr<function, Pulled_0>,  vertex_2 : Vertex_0,  wo_1 : vec3<f32>,  by_direction_0 : vec3<f32>)
{
    var local_1 : vec3<f32> = to_local_0(vertex_2.axes_4, by_direction_0);
    var _S1041 : Axes_0 = (*pulled_2).axes_5;
    axes_back_0(&(_S1041), wo_1, by_direction_0);
    (*pulled_2).axes_5 = _S1041;
    (*pulled_2).wi_2 = (*pulled_2).wi_2 + vec3<f32>((vec2<f32>(0) - local_1.xy), local_1.z);
    return;
}

fn change_word_0( at_11 : u32) -> u32
{
    return input_0[launch_0.room_0 + at_11];
}

fn walks_0() -> bool
{
    return (change_word_0(u32(6))) != u32(0);
}

fn turns_0( vertex_3 : Vertex_0) -> bool
{
    return (change_word_0(u32(1))) != u32(0);
}

fn turning_back_0( pulled_3 : ptr<function, Pulled_0>,  vertex_4 : Vertex_0,  direction_4 : vec3<f32>,  by_direction_1 : vec3<f32>)
{
    if(turns_0(vertex_4))
    {
        (*pulled_3).axes_5.n_0 = (*pulled_3).axes_5.n_0 + (by_direction_1 * vec3<f32>(dot(vertex_4.axes_4.n_0, direction_4)) - direction_4 * vec3<f32>(dot(vertex_4.axes_4.n_0, by_direction_1)));
    }
    return;
}

fn slot_derivative_0( numbers_6 : Numbers_0,  slot_2 : u32) -> vec3<f32>
{
    switch(slot_2)
    {
    case u32(0):
        {
            return numbers_6.diffuse_reflectance_0;
        }
    case u32(1):
        {
            return numbers_6.specular_reflectance_0;
        }
    case u32(2):
        {
            return numbers_6.eta_0;
        }
    case u32(3):
        {
            return numbers_6.k_0;
        }
    case u32(4):
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_6.alpha_0.x);
        }
    default :
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_6.alpha_0.y);
        }
    }
}

fn numbers_of_0( texture_6 : u32) -> u32
{
    return change_word_0(u32(7) + word_0(texture_6 + u32(18)));
}

fn add_to_sum_0( sum_3 : u32,  derivative_0 : f32)
{
    if(!((abs(derivative_0)) < 3.00000000549775576e+38f))
    {
        var _S1042 : u32 = atomicAdd(&(sums_0[u32(1)]), u32(1));
        return;
    }
    var scaled_0 : f32 = derivative_0 * (bitcast<f32>((change_word_0(u32(2)))));
    var size_1 : f32 = abs(scaled_0);
    if(size_1 > 7.73712524553362672e+25f)
    {
        var _S1043 : u32 = atomicAdd(&(sums_0[u32(0)]), u32(1));
        return;
    }
    var _S1044 : bool = scaled_0 < 0.0f;
    var _S1045 : i32;
    if(size_1 >= 1.84467440737095516e+19f)
    {
        _S1045 = i32(1);
    }
    else
    {
        _S1045 = i32(0);
    }
    var first_2 : u32 = u32(_S1045);
    var size_2 : f32;
    if(first_2 == u32(1))
    {
        size_2 = size_1 * 2.32830643653869629e-10f;
    }
    else
    {
        size_2 = size_1;
    }
    var higher_0 : f32 = floor(size_2 * 2.32830643653869629e-10f);
    var lower_0 : f32 = size_2 - higher_0 * 4.294967296e+09f;
    if(first_2 == u32(0))
    {
        size_2 = lower_0 + 0.5f;
    }
    else
    {
        size_2 = lower_0;
    }
    var _S1046 : u32 = u32(4) + u32(4) * sum_3;
    var digits_0 : vec2<u32> = vec2<u32>(u32(size_2), u32(higher_0));
    var k_2 : u32 = first_2;
    for(;;)
    {
        var _S1047 : bool;
        if(k_2 < u32(4))
        {
            _S1047 = (((digits_0.x) | ((digits_0.y)))) != u32(0);
        }
        else
        {
            _S1047 = false;
        }
        if(_S1047)
        {
        }
        else
        {
            break;
        }
        var _S1048 : u32;
        if(_S1044)
        {
            _S1048 = u32(0) - digits_0.x;
        }
        else
        {
            _S1048 = digits_0.x;
        }
        var before_0 : u32 = atomicAdd(&(sums_0[_S1046 + k_2]), _S1048);
        var overflows_0 : bool;
        if(_S1044)
        {
            overflows_0 = before_0 < (digits_0.x);
        }
        else
        {
            overflows_0 = (before_0 + digits_0.x) < before_0;
        }
        var _S1049 : u32 = digits_0.y;
        if(overflows_0)
        {
            _S1045 = i32(1);
        }
        else
        {
            _S1045 = i32(0);
        }
        var _S1050 : vec2<u32> = vec2<u32>(_S1049 + u32(_S1045), u32(0));
        var _S1051 : u32 = k_2 + u32(1);
        digits_0 = _S1050;
        k_2 = _S1051;
    }
    return;
}

fn add_to_texels_0( texture_7 : u32,  lookup_5 : Lookup_0,  derivative_1 : vec3<f32>)
{
    var first_3 : u32 = numbers_of_0(texture_7);
    var _S1052 : u32 = word_0(texture_7 + u32(1));
    var _S1053 : u32;
    if(first_3 == u32(4294967295))
    {
        _S1053 = u32(0);
    }
    else
    {
        _S1053 = lookup_5.count_0;
    }
    var k_3 : u32 = u32(0);
    for(;;)
    {
        if(k_3 < _S1053)
        {
        }
        else
        {
            break;
        }
        var own_0 : vec3<f32> = derivative_1 * vec3<f32>(lookup_5.weights_1[k_3]);
        var own_1 : vec3<f32>;
        if(_S1052 == u32(1))
        {
            own_1 = vec3<f32>((own_0.x + own_0.y + own_0.z));
        }
        else
        {
            own_1 = own_0;
        }
        var c_3 : u32 = u32(0);
        for(;;)
        {
            if(c_3 < _S1052)
            {
            }
            else
            {
                break;
            }
            add_to_sum_0(first_3 + _S1052 * lookup_5.texels_0[k_3] + c_3, own_1[c_3]);
            c_3 = c_3 + u32(1);
        }
        k_3 = k_3 + u32(1);
    }
    return;
}

fn lookup_back_0( texture_8 : u32,  lookup_6 : Lookup_0,  derivative_2 : vec3<f32>) -> vec2<f32>
{
    add_to_texels_0(texture_8, lookup_6, derivative_2);
    return vec2<f32>(dot(weighted_texels_0(texture_8, lookup_6, lookup_6.by_first_0), derivative_2), dot(weighted_texels_0(texture_8, lookup_6, lookup_6.by_second_0), derivative_2));
}

fn numbers_back_0( material_1 : u32,  place_11 : Place_0,  numbers_7 : Numbers_0) -> vec2<f32>
{
    var _S1054 : vec2<f32> = vec2<f32>(0.0f);
    var _S1055 : u32 = word_0(material_1 + u32(4));
    var slot_3 : u32 = u32(0);
    var by_place_0 : vec2<f32> = _S1054;
    for(;;)
    {
        if(slot_3 < _S1055)
        {
        }
        else
        {
            break;
        }
        var texture_9 : u32 = word_0(material_1 + u32(5) + slot_3);
        if(texture_9 == u32(4294967295))
        {
            slot_3 = slot_3 + u32(1);
            continue;
        }
        var _S1056 : Lookup_0 = lookup_at_0(texture_9, place_11);
        var _S1057 : vec2<f32> = lookup_back_0(texture_9, _S1056, slot_derivative_0(numbers_7, slot_3));
        by_place_0 = by_place_0 + _S1057;
        slot_3 = slot_3 + u32(1);
    }
    return by_place_0;
}

fn is_moving_0() -> bool
{
    return (change_word_0(u32(0))) != u32(4294967295);
}

struct AtCorners_0
{
     a_10 : vec3<f32>,
     b_7 : vec3<f32>,
     c_4 : vec3<f32>,
};

fn at_no_corner_0() -> AtCorners_0
{
    var corners_0 : AtCorners_0;
    var _S1058 : vec3<f32> = vec3<f32>(0.0f);
    corners_0.c_4 = _S1058;
    corners_0.b_7 = _S1058;
    corners_0.a_10 = _S1058;
    return corners_0;
}

fn unit_back_0( vector_1 : vec3<f32>,  derivative_3 : vec3<f32>,  size_3 : f32) -> vec3<f32>
{
    return (derivative_3 - vector_1 * vec3<f32>(dot(vector_1, derivative_3))) / vec3<f32>(size_3);
}

fn tangent_back_0( points_0 : ptr<function, AtCorners_0>,  triangle_6 : u32,  tangent_3 : vec3<f32>,  by_tangent_0 : vec3<f32>)
{
    var corner_0 : u32 = u32(9) * triangle_6;
    var uvs_2 : Corners2_0 = uvs_of_0(triangle_6);
    var _S1059 : vec2<f32> = vec2<f32>(uvs_2.b_4 - uvs_2.a_7);
    var _S1060 : vec2<f32> = vec2<f32>(uvs_2.c_1 - uvs_2.a_7);
    var _S1061 : f32 = _S1060.y;
    var _S1062 : f32 = _S1059.y;
    var scale_2 : f32 = 1.0f / (_S1059.x * _S1061 - _S1060.x * _S1062);
    var of_ab_0 : f32 = _S1061 * scale_2;
    var of_ac_0 : f32 = - _S1062 * scale_2;
    var a_11 : vec3<f64> = primitive_vector_0(corner_0);
    var _S1063 : vec3<f32> = vec3<f32>(of_ab_0);
    var _S1064 : vec3<f32> = vec3<f32>(of_ac_0);
    var derivative_4 : vec3<f32> = unit_back_0(tangent_3, by_tangent_0, length(vec3<f32>(primitive_vector_0(corner_0 + u32(3)) - a_11) * _S1063 + vec3<f32>(primitive_vector_0(corner_0 + u32(6)) - a_11) * _S1064));
    (*points_0).a_10 = (*points_0).a_10 - derivative_4 * vec3<f32>((of_ab_0 + of_ac_0));
    (*points_0).b_7 = (*points_0).b_7 + derivative_4 * _S1063;
    (*points_0).c_4 = (*points_0).c_4 + derivative_4 * _S1064;
    return;
}

fn add_at_place_0( corners_1 : ptr<function, AtCorners_0>,  place_12 : Place_0,  derivative_5 : vec3<f32>)
{
    (*corners_1).a_10 = (*corners_1).a_10 + derivative_5 * vec3<f32>((1.0f - place_12.v_0 - place_12.w_0));
    (*corners_1).b_7 = (*corners_1).b_7 + derivative_5 * vec3<f32>(place_12.v_0);
    (*corners_1).c_4 = (*corners_1).c_4 + derivative_5 * vec3<f32>(place_12.w_0);
    return;
}

fn add_at_place_1( corners_2 : ptr<function, AtCorners_0>,  place_13 : Place_0,  derivative_6 : vec3<f32>)
{
    (*corners_2).a_10 = (*corners_2).a_10 + derivative_6 * vec3<f32>((1.0f - place_13.v_0 - place_13.w_0));
    (*corners_2).b_7 = (*corners_2).b_7 + derivative_6 * vec3<f32>(place_13.v_0);
    (*corners_2).c_4 = (*corners_2).c_4 + derivative_6 * vec3<f32>(place_13.w_0);
    return;
}

fn normals_of_0( triangle_7 : u32) -> u32
{
    return change_word_0(change_word_0(u32(0)) + u32(2) * word_0(triangle_record_0(triangle_7)) + u32(1));
}

fn add_to_sums_0( first_4 : u32,  derivative_7 : vec3<f32>)
{
    var _S1065 : i32;
    if(first_4 == u32(4294967295))
    {
        _S1065 = i32(0);
    }
    else
    {
        _S1065 = i32(3);
    }
    var _S1066 : u32 = u32(_S1065);
    var axis_0 : u32 = u32(0);
    for(;;)
    {
        if(axis_0 < _S1066)
        {
        }
        else
        {
            break;
        }
        add_to_sum_0(first_4 + axis_0, derivative_7[axis_0]);
        axis_0 = axis_0 + u32(1);
    }
    return;
}

fn add_to_corners_0( sums_at_0 : u32,  triangle_8 : u32,  corners_3 : AtCorners_0)
{
    var _S1067 : u32 = triangle_record_0(triangle_8) + u32(2);
    var _S1068 : i32;
    if(sums_at_0 == u32(4294967295))
    {
        _S1068 = i32(0);
    }
    else
    {
        _S1068 = i32(3);
    }
    var _S1069 : u32 = u32(_S1068);
    var k_4 : u32 = u32(0);
    for(;;)
    {
        if(k_4 < _S1069)
        {
        }
        else
        {
            break;
        }
        var _S1070 : u32 = sums_at_0 + u32(3) * word_0(_S1067 + k_4);
        var _S1071 : vec3<f32>;
        if(k_4 == u32(0))
        {
            _S1071 = corners_3.a_10;
        }
        else
        {
            if(k_4 == u32(1))
            {
                _S1071 = corners_3.b_7;
            }
            else
            {
                _S1071 = corners_3.c_4;
            }
        }
        add_to_sums_0(_S1070, _S1071);
        k_4 = k_4 + u32(1);
    }
    return;
}

fn place_back_0( points_1 : ptr<function, AtCorners_0>,  place_14 : Place_0,  by_place_1 : vec2<f32>,  by_position_0 : vec3<f32>,  direction_5 : vec3<f32>) -> vec3<f32>
{
    var corner_1 : u32 = u32(9) * place_14.triangle_0;
    var a_12 : vec3<f64> = primitive_vector_0(corner_1);
    var _S1072 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_1 + u32(3)) - a_12);
    var _S1073 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_1 + u32(6)) - a_12);
    var across_1 : vec3<f32> = cross(_S1072, _S1073);
    var _S1074 : f32 = max(max(abs(across_1.x), abs(across_1.y)), abs(across_1.z));
    var normal_0 : vec3<f32> = across_1 / vec3<f32>(_S1074);
    var by_slip_0 : vec3<f32> = by_position_0 + (cross(_S1073, normal_0) * vec3<f32>(by_place_1.x) + cross(normal_0, _S1072) * vec3<f32>(by_place_1.y)) * vec3<f32>((1.0f / (dot(normal_0, normal_0) * _S1074)));
    var by_drift_0 : vec3<f32> = by_slip_0 - normal_0 * vec3<f32>((dot(direction_5, by_slip_0) / dot(normal_0, direction_5)));
    add_at_place_1(&((*points_1)), place_14, by_position_0 - by_drift_0);
    return by_drift_0;
}

fn surface_back_0( points_2 : ptr<function, AtCorners_0>,  surface_5 : Surface_0,  by_place_2 : vec2<f32>,  by_position_1 : vec3<f32>,  by_outward_0 : vec3<f32>,  direction_6 : vec3<f32>) -> vec3<f32>
{
    var normals_1 : u32 = word_0(surface_5.shape_0);
    var _S1075 : vec2<f32>;
    if(normals_1 == u32(4294967295))
    {
        var corner_2 : u32 = u32(9) * surface_5.place_4.triangle_0;
        var a_13 : vec3<f64> = primitive_vector_0(corner_2);
        var _S1076 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_2 + u32(3)) - a_13);
        var _S1077 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_2 + u32(6)) - a_13);
        var derivative_8 : vec3<f32> = unit_back_0(surface_5.outward_0, by_outward_0, length(cross(_S1076, _S1077)));
        var by_ab_0 : vec3<f32> = cross(_S1077, derivative_8);
        var by_ac_0 : vec3<f32> = cross(derivative_8, _S1076);
        (*points_2).a_10 = (*points_2).a_10 - (by_ab_0 + by_ac_0);
        (*points_2).b_7 = (*points_2).b_7 + by_ab_0;
        (*points_2).c_4 = (*points_2).c_4 + by_ac_0;
        _S1075 = by_place_2;
    }
    else
    {
        var record_4 : u32 = triangle_record_0(surface_5.place_4.triangle_0) + u32(2);
        var a_14 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_4));
        var ab_0 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_4 + u32(1))) - a_14;
        var ac_0 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_4 + u32(2))) - a_14;
        var derivative_9 : vec3<f32> = unit_back_0(surface_5.outward_0, by_outward_0, length(a_14 + ab_0 * vec3<f32>(surface_5.place_4.v_0) + ac_0 * vec3<f32>(surface_5.place_4.w_0)));
        var of_normals_0 : AtCorners_0 = at_no_corner_0();
        add_at_place_0(&(of_normals_0), surface_5.place_4, derivative_9);
        add_to_corners_0(normals_of_0(surface_5.place_4.triangle_0), surface_5.place_4.triangle_0, of_normals_0);
        _S1075 = by_place_2 + vec2<f32>(dot(ab_0, derivative_9), dot(ac_0, derivative_9));
    }
    var _S1078 : vec3<f32> = place_back_0(&((*points_2)), surface_5.place_4, _S1075, by_position_1, direction_6);
    return _S1078;
}

fn points_of_0( triangle_9 : u32) -> u32
{
    return change_word_0(change_word_0(u32(0)) + u32(2) * word_0(triangle_record_0(triangle_9)));
}

struct ByRay_0
{
     drift_0 : vec3<f32>,
     direction_7 : vec3<f32>,
};

fn vertex_back_0( pulled_4 : Pulled_0,  vertex_5 : Vertex_0,  material_2 : u32,  direction_8 : vec3<f32>) -> ByRay_0
{
    var by_ray_0 : ByRay_0;
    var _S1079 : vec3<f32> = vec3<f32>(0.0f);
    by_ray_0.direction_7 = _S1079;
    by_ray_0.drift_0 = _S1079;
    var by_place_3 : vec2<f32> = numbers_back_0(material_2, vertex_5.surface_3.place_4, pulled_4.numbers_4);
    if(!is_moving_0())
    {
        return by_ray_0;
    }
    var _S1080 : Axes_0 = Axes_x24_syn_dzero_0();
    var towards_0 : DiffPair_Axes_0;
    towards_0.primal_0 = vertex_5.axes_4;
    towards_0.differential_0 = _S1080;
    var incoming_0 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    incoming_0.primal_0 = direction_8;
    incoming_0.differential_0 = _S1079;
    _S190(&(towards_0), &(incoming_0), pulled_4.wi_2);
    by_ray_0.direction_7 = incoming_0.differential_0;
    var outward_1 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    outward_1.primal_0 = vertex_5.surface_3.outward_0;
    outward_1.differential_0 = _S1079;
    var _S1081 : vec3<f32> = tangent_at_0(vertex_5.surface_3);
    var tangent_4 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    tangent_4.primal_0 = _S1081;
    tangent_4.differential_0 = _S1079;
    var by_axes_0 : Axes_0 = Axes_x24_syn_dadd_0(pulled_4.axes_5, towards_0.differential_0);
    var points_3 : AtCorners_0 = at_no_corner_0();
    if((any((_S1081 != _S1079))))
    {
        _S141(&(outward_1), &(tangent_4), vertex_5.surface_3.is_front_0, by_axes_0);
        tangent_back_0(&(points_3), vertex_5.surface_3.place_4.triangle_0, tangent_4.primal_0, tangent_4.differential_0);
    }
    else
    {
        _S110(&(outward_1), vertex_5.surface_3.is_front_0, by_axes_0);
    }
    var _S1082 : vec3<f32> = surface_back_0(&(points_3), vertex_5.surface_3, by_place_3, pulled_4.position_1, outward_1.differential_0, direction_8);
    by_ray_0.drift_0 = _S1082;
    add_to_corners_0(points_of_0(vertex_5.surface_3.place_4.triangle_0), vertex_5.surface_3.place_4.triangle_0, points_3);
    return by_ray_0;
}

fn set_word_0( path_3 : u32,  which_3 : u32,  value_6 : u32)
{
    paths_0[which_3 * launch_0.room_0 + path_3] = value_6;
    return;
}

fn set_vector_0( path_4 : u32,  which_4 : ptr<function, u32>,  value_7 : vec3<f32>)
{
    var axis_1 : u32 = u32(0);
    for(;;)
    {
        if(axis_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_4, (*which_4) + axis_1, (bitcast<u32>((value_7[axis_1]))));
        axis_1 = axis_1 + u32(1);
    }
    (*which_4) = (*which_4) + u32(3);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S1083 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S1084 : u32 = u32(2) + zero_0;
        _S1083 = _S1084;
        if(rounds_0 < _S1084)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S1083;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S1085 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn go_back(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var at_12 : u32 = launch_0.first_0 + thread_0.x;
    if(at_12 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_0 : u32 = input_0[at_12];
    var kept_0 : u32 = kept_at_0(launch_0.depth_0);
    var which_5 : u32 = u32(17);
    var importance_0 : vec3<f32> = path_vector_0(number_of_path_0, &(kept_0));
    var place_15 : Place_0 = path_place_0(number_of_path_0, &(kept_0));
    var direction_9 : vec3<f32> = path_vector_0(number_of_path_0, &(kept_0));
    var direct_0 : vec3<f32> = path_vector_0(number_of_path_0, &(kept_0));
    var onward_1 : vec3<f32> = path_vector_0(number_of_path_0, &(kept_0));
    var wo_2 : vec3<f32> = path_vector_0(number_of_path_0, &(kept_0));
    var by_ray_1 : ByRay_0;
    var _S1086 : vec3<f32> = path_vector_0(number_of_path_0, &(kept_0));
    by_ray_1.drift_0 = _S1086;
    var _S1087 : vec3<f32> = path_vector_0(number_of_path_0, &(kept_0));
    by_ray_1.direction_7 = _S1087;
    var is_specular_1 : bool = (path_word_0(number_of_path_0, kept_0)) != u32(0);
    var factor_0 : f32 = (bitcast<f32>((path_word_0(number_of_path_0, kept_0 + u32(1)))));
    var t_1 : f32 = (bitcast<f32>((path_word_0(number_of_path_0, kept_0 + u32(2)))));
    var beyond_0 : vec3<f32> = path_vector_0(number_of_path_0, &(which_5));
    var by_drift_1 : vec3<f32> = path_vector_0(number_of_path_0, &(which_5));
    var by_direction_2 : vec3<f32> = path_vector_0(number_of_path_0, &(which_5));
    var surface_6 : Surface_0 = surface_at_0(place_15, direction_9);
    var material_3 : u32 = material_of_0(surface_6);
    var _S1088 : vec4<f32> = vec4<f32>(0.0f);
    var _S1089 : bool;
    if(material_3 != u32(4294967295))
    {
        _S1089 = factor_0 != 0.0f;
    }
    else
    {
        _S1089 = false;
    }
    var by_walk_0 : vec4<f32>;
    if(_S1089)
    {
        var vertex_6 : Vertex_0 = vertex_at_0(surface_6, material_3, direction_9);
        var pulled_5 : Pulled_0 = nothing_pulled_0();
        var onward_direction_0 : vec3<f32> = normalize(to_world_0(vertex_6.axes_4, wo_2));
        pulled_5.position_1 = by_drift_1;
        var by_direction_3 : vec3<f32> = by_direction_2 + by_drift_1 * vec3<f32>(t_1);
        var _S1090 : vec3<f32> = scattered_back_0(&(pulled_5), vertex_6, wo_2, onward_direction_0, is_specular_1, importance_0 * beyond_0 * vec3<f32>(factor_0));
        var by_direction_4 : vec3<f32> = by_direction_3 + _S1090;
        if(is_specular_1)
        {
            specular_direction_back_0(&(pulled_5), vertex_6, wo_2, by_direction_4);
            by_walk_0 = _S1088;
        }
        else
        {
            if(walks_0())
            {
                by_walk_0 = vec4<f32>(by_direction_4, dot(importance_0 * onward_1, beyond_0));
            }
            else
            {
                turning_back_0(&(pulled_5), vertex_6, onward_direction_0, by_direction_4);
                by_walk_0 = _S1088;
            }
        }
        var onward_by_ray_0 : ByRay_0 = vertex_back_0(pulled_5, vertex_6, material_3, direction_9);
        by_ray_1.drift_0 = by_ray_1.drift_0 + onward_by_ray_0.drift_0;
        by_ray_1.direction_7 = by_ray_1.direction_7 + onward_by_ray_0.direction_7;
    }
    else
    {
        by_walk_0 = _S1088;
    }
    if(walks_0())
    {
        which_5 = kept_at_0(launch_0.depth_0) + u32(11);
        set_vector_0(number_of_path_0, &(which_5), by_walk_0.xyz);
        set_word_0(number_of_path_0, which_5, (bitcast<u32>((by_walk_0.w))));
    }
    which_5 = u32(17);
    set_vector_0(number_of_path_0, &(which_5), direct_0 + onward_1 * beyond_0);
    set_vector_0(number_of_path_0, &(which_5), by_ray_1.drift_0);
    set_vector_0(number_of_path_0, &(which_5), by_ray_1.direction_7);
    check_loops_0();
    return;
}
