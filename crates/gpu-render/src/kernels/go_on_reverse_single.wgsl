// Compiled from reverse.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 56d966057bf54911
// result: d5cb3422a4ccabae

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

struct Tuple_5
{
     value0_7 : f32,
};

fn s_apply_min_0( x_8 : f32,  y_2 : f32) -> Tuple_5
{
    var _S48 : Tuple_5 = Tuple_5( min(x_8, y_2) );
    return _S48;
}

struct s_bwdCallableCtx_min_0
{
     _S49 : f32,
     _S50 : f32,
};

fn _d_min_0( dpx_4 : ptr<function, DiffPair_float_0>,  dpy_3 : ptr<function, DiffPair_float_0>,  dOut_4 : f32)
{
    var _S51 : DiffPair_float_0 = (*dpx_4);
    var _S52 : f32;
    if(((*dpx_4).primal_0) < ((*dpy_3).primal_0))
    {
        _S52 = dOut_4;
    }
    else
    {
        if(((*dpx_4).primal_0) > ((*dpy_3).primal_0))
        {
            _S52 = 0.0f;
        }
        else
        {
            _S52 = 0.5f * dOut_4;
        }
    }
    (*dpx_4).primal_0 = _S51.primal_0;
    (*dpx_4).differential_0 = _S52;
    var _S53 : DiffPair_float_0 = (*dpy_3);
    if(((*dpy_3).primal_0) < (_S51.primal_0))
    {
        _S52 = dOut_4;
    }
    else
    {
        if(((*dpy_3).primal_0) > ((*dpx_4).primal_0))
        {
            _S52 = 0.0f;
        }
        else
        {
            _S52 = 0.5f * dOut_4;
        }
    }
    (*dpy_3).primal_0 = _S53.primal_0;
    (*dpy_3).differential_0 = _S52;
    return;
}

fn s_bwdProp_min_0( ctx_5 : s_bwdCallableCtx_min_0,  d_x_5 : ptr<function, f32>,  d_y_2 : ptr<function, f32>,  d_out_5 : f32)
{
    var _S54 : DiffPair_float_0;
    _S54.primal_0 = ctx_5._S49;
    var _S55 : DiffPair_float_0;
    _S55.primal_0 = ctx_5._S50;
    _d_min_0(&(_S54), &(_S55), d_out_5);
    (*d_x_5) = _S54.differential_0;
    (*d_y_2) = _S55.differential_0;
    return;
}

struct Tuple_6
{
     value0_8 : f32,
};

fn s_apply_length_1( x_9 : vec2<f32>) -> Tuple_6
{
    var _S56 : Tuple_6 = Tuple_6( length(x_9) );
    return _S56;
}

struct s_bwdCallableCtx_length_1
{
     _S57 : vec2<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_length_impl_1
{
     value0_9 : vec2<f32>,
};

struct s_bwdCallableCtx_length_impl_1
{
     value0_10 : s_paramCtx_s_bwdCallableCtx_length_impl_1,
};

fn s_bwdProp_length_impl_1( _S58 : s_bwdCallableCtx_length_impl_1,  _S59 : ptr<function, vec2<f32>>,  _S60 : f32)
{
    var _S61 : f32 = _S58.value0_10.value0_9[i32(0)];
    var _S62 : f32 = _S58.value0_10.value0_9[i32(1)];
    var _S63 : s_bwdCallableCtx_sqrt_0;
    _S63._S3 = _S61 * _S61 + _S62 * _S62;
    var _S64 : f32 = 0.0f;
    s_bwdProp_sqrt_0(_S63, &(_S64), _S60);
    var _S65 : f32 = _S58.value0_10.value0_9[i32(1)] * _S64;
    var _S66 : f32 = _S65 + _S65;
    var _S67 : f32 = _S58.value0_10.value0_9[i32(0)] * _S64;
    var _S68 : f32 = _S67 + _S67;
    var _S69 : vec2<f32> = vec2<f32>(0.0f);
    _S69[i32(1)] = _S66;
    _S69[i32(0)] = _S68;
    (*_S59) = _S69;
    return;
}

fn _S70( _S71 : ptr<function, DiffPair_vectorx3Cfloatx2C2x3E_0>,  _S72 : f32)
{
    var _S73 : s_paramCtx_s_bwdCallableCtx_length_impl_1;
    _S73.value0_9 = (*_S71).primal_0;
    var _S74 : s_bwdCallableCtx_length_impl_1 = s_bwdCallableCtx_length_impl_1( _S73 );
    var _S75 : vec2<f32> = (*_S71).differential_0;
    s_bwdProp_length_impl_1(_S74, &(_S75), _S72);
    (*_S71).differential_0 = _S75;
    return;
}

fn s_bwdProp_length_1( ctx_6 : s_bwdCallableCtx_length_1,  d_x_6 : ptr<function, vec2<f32>>,  d_out_6 : f32)
{
    var _S76 : DiffPair_vectorx3Cfloatx2C2x3E_0;
    _S76.primal_0 = ctx_6._S57;
    _S70(&(_S76), d_out_6);
    (*d_x_6) = _S76.differential_0;
    return;
}

struct s_bwdCallableCtx_cross_0
{
     _S77 : vec3<f32>,
     _S78 : vec3<f32>,
};

fn _d_cross_0( a_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  b_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dOut_5 : vec3<f32>)
{
    var _S79 : f32 = dOut_5.y;
    var _S80 : f32 = dOut_5.z;
    var _S81 : f32 = dOut_5.x;
    var _S82 : f32 = (*a_0).primal_0.z * _S79 + - (*a_0).primal_0.y * _S80;
    var _S83 : f32 = - (*a_0).primal_0.z * _S81 + (*a_0).primal_0.x * _S80;
    var _S84 : f32 = (*a_0).primal_0.y * _S81 + - (*a_0).primal_0.x * _S79;
    var _S85 : vec3<f32> = vec3<f32>(- (*b_0).primal_0.z * _S79 + (*b_0).primal_0.y * _S80, (*b_0).primal_0.z * _S81 + - (*b_0).primal_0.x * _S80, - (*b_0).primal_0.y * _S81 + (*b_0).primal_0.x * _S79);
    (*a_0).primal_0 = (*a_0).primal_0;
    (*a_0).differential_0 = _S85;
    var _S86 : vec3<f32> = vec3<f32>(_S82, _S83, _S84);
    (*b_0).primal_0 = (*b_0).primal_0;
    (*b_0).differential_0 = _S86;
    return;
}

fn s_bwdProp_cross_0( ctx_7 : s_bwdCallableCtx_cross_0,  d_left_0 : ptr<function, vec3<f32>>,  d_right_0 : ptr<function, vec3<f32>>,  d_out_7 : vec3<f32>)
{
    var _S87 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S87.primal_0 = ctx_7._S77;
    var _S88 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S88.primal_0 = ctx_7._S78;
    _d_cross_0(&(_S87), &(_S88), d_out_7);
    (*d_left_0) = _S87.differential_0;
    (*d_right_0) = _S88.differential_0;
    return;
}

struct Tuple_7
{
     value0_11 : vec3<f32>,
};

fn s_apply_normalize_0( x_10 : vec3<f32>) -> Tuple_7
{
    var _S89 : Tuple_7 = Tuple_7( normalize(x_10) );
    return _S89;
}

struct s_bwdCallableCtx_normalize_0
{
     _S90 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_normalize_impl_0
{
     value0_12 : vec3<f32>,
};

struct s_bwdCallableCtx_normalize_impl_0
{
     value0_13 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0,
};

fn s_bwdProp_normalize_impl_0( _S91 : s_bwdCallableCtx_normalize_impl_0,  _S92 : ptr<function, vec3<f32>>,  _S93 : vec3<f32>)
{
    var _S94 : Tuple_0 = s_apply_length_0(_S91.value0_13.value0_12);
    var _S95 : s_bwdCallableCtx_length_0;
    _S95._S2 = _S91.value0_13.value0_12;
    var _S96 : vec3<f32> = _S91.value0_13.value0_12 * _S93;
    var _S97 : vec3<f32> = vec3<f32>((1.0f / _S94.value0_0)) * _S93;
    var _S98 : f32 = - ((_S96[i32(0)] + _S96[i32(1)] + _S96[i32(2)]) / (_S94.value0_0 * _S94.value0_0));
    var _S99 : vec3<f32> = vec3<f32>(0.0f);
    s_bwdProp_length_0(_S95, &(_S99), _S98);
    (*_S92) = _S97 + _S99;
    return;
}

fn _S100( _S101 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S102 : vec3<f32>)
{
    var _S103 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0;
    _S103.value0_12 = (*_S101).primal_0;
    var _S104 : s_bwdCallableCtx_normalize_impl_0 = s_bwdCallableCtx_normalize_impl_0( _S103 );
    var _S105 : vec3<f32> = (*_S101).differential_0;
    s_bwdProp_normalize_impl_0(_S104, &(_S105), _S102);
    (*_S101).differential_0 = _S105;
    return;
}

fn s_bwdProp_normalize_0( ctx_8 : s_bwdCallableCtx_normalize_0,  d_x_7 : ptr<function, vec3<f32>>,  d_out_8 : vec3<f32>)
{
    var _S106 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S106.primal_0 = ctx_8._S90;
    _S100(&(_S106), d_out_8);
    (*d_x_7) = _S106.differential_0;
    return;
}

struct Tuple_8
{
     value0_14 : f32,
};

fn s_apply_dot_1( x_11 : vec3<f32>,  y_3 : vec3<f32>) -> Tuple_8
{
    var _S107 : Tuple_8 = Tuple_8( dot(x_11, y_3) );
    return _S107;
}

struct s_bwdCallableCtx_dot_1
{
     _S108 : vec3<f32>,
     _S109 : vec3<f32>,
};

fn _d_dot_1( dpx_5 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dpy_4 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dOut_6 : f32)
{
    var x_d_result_1 : vec3<f32>;
    x_d_result_1[i32(0)] = (*dpy_4).primal_0[i32(0)] * dOut_6;
    var y_d_result_1 : vec3<f32>;
    y_d_result_1[i32(0)] = (*dpx_5).primal_0[i32(0)] * dOut_6;
    x_d_result_1[i32(1)] = (*dpy_4).primal_0[i32(1)] * dOut_6;
    y_d_result_1[i32(1)] = (*dpx_5).primal_0[i32(1)] * dOut_6;
    x_d_result_1[i32(2)] = (*dpy_4).primal_0[i32(2)] * dOut_6;
    y_d_result_1[i32(2)] = (*dpx_5).primal_0[i32(2)] * dOut_6;
    (*dpx_5).primal_0 = (*dpx_5).primal_0;
    (*dpx_5).differential_0 = x_d_result_1;
    (*dpy_4).primal_0 = (*dpy_4).primal_0;
    (*dpy_4).differential_0 = y_d_result_1;
    return;
}

fn s_bwdProp_dot_1( ctx_9 : s_bwdCallableCtx_dot_1,  d_x_8 : ptr<function, vec3<f32>>,  d_y_3 : ptr<function, vec3<f32>>,  d_out_9 : f32)
{
    var _S110 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S110.primal_0 = ctx_9._S108;
    var _S111 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S111.primal_0 = ctx_9._S109;
    _d_dot_1(&(_S110), &(_S111), d_out_9);
    (*d_x_8) = _S110.differential_0;
    (*d_y_3) = _S111.differential_0;
    return;
}

struct Tuple_9
{
     value0_15 : f32,
};

fn s_apply_max_1( x_12 : f32,  y_4 : f32) -> Tuple_9
{
    var _S112 : Tuple_9 = Tuple_9( max(x_12, y_4) );
    return _S112;
}

struct s_bwdCallableCtx_max_1
{
     _S113 : f32,
     _S114 : f32,
};

fn s_bwdProp_max_1( ctx_10 : s_bwdCallableCtx_max_1,  d_x_9 : ptr<function, f32>,  d_y_4 : ptr<function, f32>,  d_out_10 : f32)
{
    var _S115 : DiffPair_float_0;
    _S115.primal_0 = ctx_10._S113;
    var _S116 : DiffPair_float_0;
    _S116.primal_0 = ctx_10._S114;
    _d_max_0(&(_S115), &(_S116), d_out_10);
    (*d_x_9) = _S115.differential_0;
    (*d_y_4) = _S116.differential_0;
    return;
}

struct Tuple_10
{
     value0_16 : f32,
};

fn s_apply_abs_0( x_13 : f32) -> Tuple_10
{
    var _S117 : Tuple_10 = Tuple_10( abs(x_13) );
    return _S117;
}

struct s_bwdCallableCtx_abs_0
{
     _S118 : f32,
};

fn _d_abs_0( dpx_6 : ptr<function, DiffPair_float_0>,  dOut_7 : f32)
{
    var _S119 : f32 = select(select(-1.0f, 0.0f, ((*dpx_6).primal_0) == 0.0f), 1.0f, ((*dpx_6).primal_0) > 0.0f) * dOut_7;
    (*dpx_6).primal_0 = (*dpx_6).primal_0;
    (*dpx_6).differential_0 = _S119;
    return;
}

fn s_bwdProp_abs_0( ctx_11 : s_bwdCallableCtx_abs_0,  d_x_10 : ptr<function, f32>,  d_out_11 : f32)
{
    var _S120 : DiffPair_float_0;
    _S120.primal_0 = ctx_11._S118;
    _d_abs_0(&(_S120), d_out_11);
    (*d_x_10) = _S120.differential_0;
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
     value0_17 : vec3<f32>,
     value1_0 : bool,
};

struct s_bwdCallableCtx_axes_around_0
{
     value0_18 : s_paramCtx_s_bwdCallableCtx_axes_around_0,
};

fn s_bwdProp_axes_around_0( _S121 : s_bwdCallableCtx_axes_around_0,  _S122 : ptr<function, vec3<f32>>,  _S123 : Axes_0)
{
    var _S124 : f32 = _S121.value0_18.value0_17.z;
    var sign_0 : f32;
    if(_S124 < -0.00000999999974738f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var _S125 : f32 = sign_0 + _S124;
    var a_1 : f32 = -1.0f / _S125;
    var _S126 : f32 = _S125 * _S125;
    var _S127 : f32 = _S121.value0_18.value0_17.x;
    var _S128 : f32 = _S121.value0_18.value0_17.y;
    var _S129 : f32 = _S127 * _S128;
    var _S130 : f32 = sign_0 * _S127;
    var _S131 : f32 = _S130 * _S127;
    var _S132 : f32 = - sign_0;
    var _S133 : f32 = _S128 * _S128;
    var _S134 : f32 = _S128 * (a_1 * _S123.t_0[i32(1)]);
    var _S135 : f32 = a_1 * _S123.s_0[i32(0)];
    var _S136 : f32 = _S123.t_0[i32(0)] + sign_0 * _S123.s_0[i32(1)];
    var _S137 : f32 = a_1 * _S136;
    var _S138 : vec3<f32> = vec3<f32>(_S132 * _S123.s_0[i32(2)] + _S130 * _S135 + sign_0 * (_S127 * _S135) + _S128 * _S137, - _S123.t_0[i32(2)] + _S134 + _S134 + _S127 * _S137, 0.0f) + vec3<f32>(0.0f, 0.0f, -1.0f * - ((_S133 * _S123.t_0[i32(1)] + _S131 * _S123.s_0[i32(0)] + _S129 * _S136) / _S126));
    var _S139 : vec3<f32>;
    if(_S121.value0_18.value1_0)
    {
        _S139 = _S123.n_0 + _S138;
    }
    else
    {
        _S139 = (vec3<f32>(0) - _S123.n_0) + _S138;
    }
    (*_S122) = _S139;
    return;
}

fn _S140( _S141 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S142 : bool,  _S143 : Axes_0)
{
    var _S144 : s_paramCtx_s_bwdCallableCtx_axes_around_0;
    _S144.value0_17 = (*_S141).primal_0;
    _S144.value1_0 = _S142;
    var _S145 : s_bwdCallableCtx_axes_around_0 = s_bwdCallableCtx_axes_around_0( _S144 );
    var _S146 : vec3<f32> = (*_S141).differential_0;
    s_bwdProp_axes_around_0(_S145, &(_S146), _S143);
    (*_S141).differential_0 = _S146;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_axes_along_0
{
     value0_19 : vec3<f32>,
     value1_1 : vec3<f32>,
     value2_0 : bool,
};

struct s_bwdCallableCtx_axes_along_0
{
     value0_20 : s_paramCtx_s_bwdCallableCtx_axes_along_0,
};

fn s_bwdProp_axes_along_0( _S147 : s_bwdCallableCtx_axes_along_0,  _S148 : ptr<function, vec3<f32>>,  _S149 : ptr<function, vec3<f32>>,  _S150 : Axes_0)
{
    var _S151 : vec3<f32> = vec3<f32>(s_apply_dot_1(_S147.value0_20.value0_19, _S147.value0_20.value1_1).value0_14);
    var _S152 : s_bwdCallableCtx_dot_1;
    _S152._S108 = _S147.value0_20.value0_19;
    _S152._S109 = _S147.value0_20.value1_1;
    var _S153 : vec3<f32> = _S147.value0_20.value1_1 - _S147.value0_20.value0_19 * _S151;
    var _S154 : Tuple_7 = s_apply_normalize_0(_S153);
    var _S155 : s_bwdCallableCtx_normalize_0;
    _S155._S90 = _S153;
    var _S156 : s_bwdCallableCtx_cross_0;
    _S156._S77 = _S147.value0_20.value0_19;
    _S156._S78 = _S154.value0_11;
    var _S157 : vec3<f32> = vec3<f32>(0.0f);
    var _S158 : vec3<f32> = _S157;
    var _S159 : vec3<f32> = _S157;
    s_bwdProp_cross_0(_S156, &(_S158), &(_S159), _S150.t_0);
    var _S160 : vec3<f32> = _S150.s_0 + _S159;
    var _S161 : vec3<f32> = _S157;
    s_bwdProp_normalize_0(_S155, &(_S161), _S160);
    var _S162 : vec3<f32> = (vec3<f32>(0) - _S161);
    var _S163 : vec3<f32> = _S147.value0_20.value0_19 * _S162;
    var _S164 : vec3<f32> = _S151 * _S162;
    var _S165 : f32 = _S163[i32(0)] + _S163[i32(1)] + _S163[i32(2)];
    var _S166 : vec3<f32> = _S157;
    var _S167 : vec3<f32> = _S157;
    s_bwdProp_dot_1(_S152, &(_S166), &(_S167), _S165);
    var _S168 : vec3<f32> = _S158 + _S164 + _S166;
    var _S169 : vec3<f32> = _S161 + _S167;
    var _S170 : vec3<f32>;
    if(_S147.value0_20.value2_0)
    {
        _S170 = _S150.n_0 + _S168;
    }
    else
    {
        _S170 = (vec3<f32>(0) - _S150.n_0) + _S168;
    }
    (*_S148) = _S170;
    (*_S149) = _S169;
    return;
}

fn _S171( _S172 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S173 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S174 : bool,  _S175 : Axes_0)
{
    var _S176 : s_paramCtx_s_bwdCallableCtx_axes_along_0;
    _S176.value0_19 = (*_S172).primal_0;
    _S176.value1_1 = (*_S173).primal_0;
    _S176.value2_0 = _S174;
    var _S177 : s_bwdCallableCtx_axes_along_0 = s_bwdCallableCtx_axes_along_0( _S176 );
    var _S178 : vec3<f32> = (*_S172).differential_0;
    var _S179 : vec3<f32> = (*_S173).differential_0;
    s_bwdProp_axes_along_0(_S177, &(_S178), &(_S179), _S175);
    (*_S172).differential_0 = _S178;
    (*_S173).differential_0 = _S179;
    return;
}

struct DiffPair_Axes_0
{
     primal_0 : Axes_0,
     differential_0 : Axes_0,
};

struct s_paramCtx_s_bwdCallableCtx_towards_viewer_0
{
     value0_21 : Axes_0,
     value1_2 : vec3<f32>,
};

struct s_bwdCallableCtx_towards_viewer_0
{
     value0_22 : s_paramCtx_s_bwdCallableCtx_towards_viewer_0,
};

struct Tuple_11
{
     value0_23 : vec3<f32>,
};

fn s_apply_to_local_0( _S180 : Axes_0,  _S181 : vec3<f32>) -> Tuple_11
{
    var _S182 : Tuple_11;
    _S182.value0_23 = vec3<f32>(s_apply_dot_1(_S180.s_0, _S181).value0_14, s_apply_dot_1(_S180.t_0, _S181).value0_14, s_apply_dot_1(_S180.n_0, _S181).value0_14);
    return _S182;
}

struct s_paramCtx_s_bwdCallableCtx_to_local_0
{
     value0_24 : Axes_0,
     value1_3 : vec3<f32>,
};

struct s_bwdCallableCtx_to_local_0
{
     value0_25 : s_paramCtx_s_bwdCallableCtx_to_local_0,
};

fn Axes_x24_syn_dzero_0() -> Axes_0
{
    var result_0 : Axes_0;
    var _S183 : vec3<f32> = vec3<f32>(0.0f);
    result_0.s_0 = _S183;
    result_0.t_0 = _S183;
    result_0.n_0 = _S183;
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

fn s_bwdProp_to_local_0( _S184 : s_bwdCallableCtx_to_local_0,  _S185 : ptr<function, Axes_0>,  _S186 : ptr<function, vec3<f32>>,  _S187 : vec3<f32>)
{
    var _S188 : s_bwdCallableCtx_dot_1;
    _S188._S108 = _S184.value0_25.value0_24.s_0;
    _S188._S109 = _S184.value0_25.value1_3;
    var _S189 : s_bwdCallableCtx_dot_1;
    _S189._S108 = _S184.value0_25.value0_24.t_0;
    _S189._S109 = _S184.value0_25.value1_3;
    var _S190 : s_bwdCallableCtx_dot_1;
    _S190._S108 = _S184.value0_25.value0_24.n_0;
    _S190._S109 = _S184.value0_25.value1_3;
    var _S191 : Axes_0 = Axes_x24_syn_dzero_0();
    var _S192 : vec3<f32> = vec3<f32>(0.0f);
    var _S193 : vec3<f32> = _S192;
    var _S194 : vec3<f32> = _S192;
    s_bwdProp_dot_1(_S190, &(_S193), &(_S194), _S187[i32(2)]);
    var _S195 : vec3<f32> = _S192;
    var _S196 : vec3<f32> = _S192;
    s_bwdProp_dot_1(_S189, &(_S195), &(_S196), _S187[i32(1)]);
    var _S197 : vec3<f32> = _S192;
    var _S198 : vec3<f32> = _S192;
    s_bwdProp_dot_1(_S188, &(_S197), &(_S198), _S187[i32(0)]);
    var _S199 : vec3<f32> = _S194 + _S196 + _S198;
    var _S200 : Axes_0 = _S191;
    _S200.n_0 = _S193;
    _S200.t_0 = _S195;
    _S200.s_0 = _S197;
    (*_S185) = Axes_x24_syn_dadd_0(_S191, _S200);
    (*_S186) = _S199;
    return;
}

fn s_bwdProp_towards_viewer_0( _S201 : s_bwdCallableCtx_towards_viewer_0,  _S202 : ptr<function, Axes_0>,  _S203 : ptr<function, vec3<f32>>,  _S204 : vec3<f32>)
{
    var _S205 : Tuple_11 = s_apply_to_local_0(_S201.value0_22.value0_21, _S201.value0_22.value1_2);
    var _S206 : s_paramCtx_s_bwdCallableCtx_to_local_0;
    _S206.value0_24 = _S201.value0_22.value0_21;
    _S206.value1_3 = _S201.value0_22.value1_2;
    var _S207 : s_bwdCallableCtx_to_local_0 = s_bwdCallableCtx_to_local_0( _S206 );
    var _S208 : f32 = (vec3<f32>(0) - _S205.value0_23).z;
    var _S209 : Tuple_10 = s_apply_abs_0(_S208);
    var _S210 : s_bwdCallableCtx_abs_0;
    _S210._S118 = _S208;
    var _S211 : s_bwdCallableCtx_max_1;
    _S211._S113 = _S209.value0_16;
    _S211._S114 = 9.999999960041972e-13f;
    var _S212 : Axes_0 = Axes_x24_syn_dzero_0();
    var _S213 : f32 = 0.0f;
    var _S214 : f32 = 0.0f;
    s_bwdProp_max_1(_S211, &(_S213), &(_S214), _S204[i32(2)]);
    var _S215 : f32 = 0.0f;
    s_bwdProp_abs_0(_S210, &(_S215), _S213);
    var _S216 : vec3<f32> = (vec3<f32>(0) - vec3<f32>(_S204[i32(0)], _S204[i32(1)], _S215));
    var _S217 : vec3<f32> = vec3<f32>(0.0f);
    var _S218 : Axes_0;
    _S218.s_0 = _S217;
    _S218.t_0 = _S217;
    _S218.n_0 = _S217;
    var _S219 : vec3<f32> = _S217;
    s_bwdProp_to_local_0(_S207, &(_S218), &(_S219), _S216);
    (*_S202) = Axes_x24_syn_dadd_0(_S218, _S212);
    (*_S203) = _S219;
    return;
}

fn _S220( _S221 : ptr<function, DiffPair_Axes_0>,  _S222 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S223 : vec3<f32>)
{
    var _S224 : s_paramCtx_s_bwdCallableCtx_towards_viewer_0;
    _S224.value0_21 = (*_S221).primal_0;
    _S224.value1_2 = (*_S222).primal_0;
    var _S225 : s_bwdCallableCtx_towards_viewer_0 = s_bwdCallableCtx_towards_viewer_0( _S224 );
    var _S226 : Axes_0 = (*_S221).differential_0;
    var _S227 : vec3<f32> = (*_S222).differential_0;
    s_bwdProp_towards_viewer_0(_S225, &(_S226), &(_S227), _S223);
    (*_S221).differential_0 = _S226;
    (*_S222).differential_0 = _S227;
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
     value0_26 : f32,
     value1_4 : f32,
};

struct s_minCtx_s_bwdCallableCtx_base_0
{
     value0_27 : f32,
     value1_5 : u32,
};

struct s_minCtx_s_bwdCallableCtx_scattering_0
{
     value0_28 : f32,
     value1_6 : s_minCtx_s_bwdCallableCtx_transmittance_0,
     value2_1 : f32,
     value3_0 : s_minCtx_s_bwdCallableCtx_transmittance_0,
     value4_0 : vec3<f32>,
     value5_0 : s_minCtx_s_bwdCallableCtx_base_0,
};

struct Tuple_12
{
     value0_29 : Scattering_0,
     value1_7 : s_minCtx_s_bwdCallableCtx_scattering_0,
};

struct Mirrored_0
{
     cosine_0 : f32,
     pdf_1 : f32,
     scattered_0 : f32,
};

struct Tuple_13
{
     value0_30 : Mirrored_0,
};

fn s_apply_Mirrored_x24init_0( _S228 : f32,  _S229 : f32,  _S230 : f32) -> Tuple_13
{
    var _S231 : Tuple_13;
    _S231.value0_30.cosine_0 = _S228;
    _S231.value0_30.pdf_1 = _S229;
    _S231.value0_30.scattered_0 = _S230;
    return _S231;
}

fn is_rough_0( lobe_0 : Lobe_0) -> bool
{
    var _S232 : bool;
    if((lobe_0.kind_0) == u32(2))
    {
        _S232 = true;
    }
    else
    {
        _S232 = (lobe_0.kind_0) == u32(4);
    }
    return _S232;
}

struct Microfacets_0
{
     distribution_1 : u32,
     alpha_1 : vec2<f32>,
};

struct Tuple_14
{
     value0_31 : Microfacets_0,
};

fn s_apply_facets_of_0( lobe_1 : Lobe_0,  _S233 : Numbers_0) -> Tuple_14
{
    var _S234 : Tuple_3 = s_apply_max_0(_S233.alpha_0, vec2<f32>(0.00009999999747379f));
    var _S235 : Tuple_14;
    _S235.value0_31.distribution_1 = lobe_1.distribution_0;
    _S235.value0_31.alpha_1 = _S234.value0_5;
    return _S235;
}

struct Tuple_15
{
     value0_32 : Mirrored_0,
};

struct Tuple_16
{
     value0_33 : f32,
};

struct Tuple_17
{
     value0_34 : f32,
};

fn s_apply_exponential_0( _S236 : f32) -> Tuple_17
{
    var _S237 : f32;
    if(!(_S236 < -87.0f))
    {
        var power_1 : f32 = floor(_S236 * 1.4426950216293335f + 0.5f);
        var r_1 : f32 = _S236 - power_1 * 0.693359375f + power_1 * 0.00021219444170129f;
        _S237 = ((((((0.00019875691214111f * r_1 + 0.00139819993637502f) * r_1 + 0.00833345204591751f) * r_1 + 0.04166579619050026f) * r_1 + 0.1666666567325592f) * r_1 + 0.5f) * r_1 * r_1 + r_1 + 1.0f) * (bitcast<f32>(((u32(i32(power_1) + i32(127)) << (u32(23))))));
    }
    else
    {
        _S237 = 0.0f;
    }
    var _S238 : Tuple_17;
    _S238.value0_34 = _S237;
    return _S238;
}

fn s_apply_density_0( _S239 : Microfacets_0,  _S240 : vec3<f32>) -> Tuple_16
{
    var _S241 : f32 = _S240.z;
    var _S242 : bool = !(_S241 <= 0.0f);
    var _S243 : f32;
    if(_S242)
    {
        var scale_0 : f32 = 3.14159274101257324f * _S239.alpha_1.x * _S239.alpha_1.y;
        var slope_1 : vec2<f32> = _S240.xy / _S239.alpha_1;
        var _S244 : Tuple_2 = s_apply_dot_0(slope_1, slope_1);
        var cos2_0 : f32 = _S241 * _S241;
        var _runFlag_0 : bool;
        if((_S239.distribution_1) == u32(1))
        {
            var sum_0 : f32 = _S244.value0_4 + cos2_0;
            var _S245 : f32 = 1.0f / (scale_0 * sum_0 * sum_0);
            _runFlag_0 = false;
            _S243 = _S245;
        }
        else
        {
            _runFlag_0 = _S242;
            _S243 = 0.0f;
        }
        if(_runFlag_0)
        {
            var exponent_0 : f32 = _S244.value0_4 / cos2_0;
            if(exponent_0 > 80.0f)
            {
                _S243 = 0.0f;
            }
            else
            {
                _S243 = s_apply_exponential_0(- exponent_0).value0_34 / (scale_0 * cos2_0 * cos2_0);
            }
        }
    }
    else
    {
        _S243 = 0.0f;
    }
    var _S246 : Tuple_16;
    _S246.value0_33 = _S243;
    return _S246;
}

struct Tuple_18
{
     value0_35 : f32,
};

fn s_apply_visible_over_cos_0( _S247 : Microfacets_0,  _S248 : vec3<f32>) -> Tuple_18
{
    var stretched_0 : vec2<f32> = _S248.xy * _S247.alpha_1;
    var _S249 : Tuple_2 = s_apply_dot_0(stretched_0, stretched_0);
    var _S250 : f32 = _S248.z;
    var z2_0 : f32 = _S250 * _S250;
    var _S251 : bool = (_S247.distribution_1) == u32(1);
    var _S252 : f32;
    if(_S251)
    {
        _S252 = 2.0f / (_S250 + s_apply_sqrt_0(z2_0 + _S249.value0_4).value0_6);
    }
    var _S253 : bool = !_S251;
    if(_S253)
    {
        var _runFlag_1 : bool;
        if(z2_0 >= (36.0f * _S249.value0_4))
        {
            var _S254 : f32 = 1.0f / _S250;
            _runFlag_1 = false;
            _S252 = _S254;
        }
        else
        {
            _runFlag_1 = _S253;
        }
        if(_runFlag_1)
        {
            var _S255 : Tuple_4 = s_apply_sqrt_0(_S249.value0_4);
            var _S256 : Tuple_1 = s_apply_error_function_plus_one_0(_S250 / _S255.value0_6);
            _S252 = 2.0f / (_S250 * _S256.value0_3.x + 0.5f * _S255.value0_6 * _S256.value0_3.y);
        }
    }
    var _S257 : Tuple_18;
    _S257.value0_35 = _S252;
    return _S257;
}

fn s_apply_mirrored_0( _S258 : Microfacets_0,  _S259 : vec3<f32>,  _S260 : vec3<f32>) -> Tuple_15
{
    var _S261 : Tuple_7 = s_apply_normalize_0(_S259 + _S260);
    var _S262 : f32 = 0.25f * s_apply_density_0(_S258, _S261.value0_11).value0_33 * s_apply_visible_over_cos_0(_S258, _S259).value0_35;
    var _S263 : f32 = _S262 * s_apply_visible_over_cos_0(_S258, _S260).value0_35 * _S260.z;
    var _S264 : Tuple_15;
    _S264.value0_32.cosine_0 = s_apply_dot_1(_S259, _S261.value0_11).value0_14;
    _S264.value0_32.pdf_1 = _S262;
    _S264.value0_32.scattered_0 = _S263;
    return _S264;
}

struct Tuple_19
{
     value0_36 : vec3<f32>,
};

struct Tuple_20
{
     value0_37 : f32,
};

fn s_apply_fresnel_conductor_channel_0( _S265 : f32,  _S266 : f32,  _S267 : f32) -> Tuple_20
{
    var cos2_1 : f32 = _S265 * _S265;
    var sin2_0 : f32 = 1.0f - cos2_1;
    var real_0 : f32 = _S266 * _S266 - _S267 * _S267 - sin2_0;
    var product_0 : f32 = _S266 * _S267;
    var _S268 : Tuple_4 = s_apply_sqrt_0(real_0 * real_0 + 4.0f * (product_0 * product_0));
    var a_2 : f32;
    if(!((_S268.value0_6) == 0.0f))
    {
        var _S269 : Tuple_4 = s_apply_sqrt_0(0.5f * (_S268.value0_6 + s_apply_abs_0(real_0).value0_16));
        var smaller_0 : f32 = product_0 / _S269.value0_6;
        var _S270 : bool = real_0 < 0.0f;
        if(_S270)
        {
            a_2 = smaller_0;
        }
        else
        {
            a_2 = _S269.value0_6;
        }
        var b_1 : f32;
        if(_S270)
        {
            b_1 = _S269.value0_6;
        }
        else
        {
            b_1 = smaller_0;
        }
        var less_0 : f32 = a_2 - _S265;
        var more_0 : f32 = a_2 + _S265;
        var _S271 : f32 = b_1 * b_1;
        var p_sum_0 : f32 = _S268.value0_6 * cos2_1 + sin2_0 * sin2_0;
        a_2 = (less_0 * less_0 + _S271) / (more_0 * more_0 + _S271) * p_sum_0 / (p_sum_0 + 2.0f * a_2 * _S265 * sin2_0);
    }
    else
    {
        a_2 = 1.0f;
    }
    var _S272 : Tuple_20;
    _S272.value0_37 = a_2;
    return _S272;
}

fn s_apply_fresnel_conductor_0( _S273 : f32,  _S274 : vec3<f32>,  _S275 : vec3<f32>) -> Tuple_19
{
    var _S276 : Tuple_19;
    _S276.value0_36 = vec3<f32>(s_apply_fresnel_conductor_channel_0(_S273, _S274.x, _S275.x).value0_37, s_apply_fresnel_conductor_channel_0(_S273, _S274.y, _S275.y).value0_37, s_apply_fresnel_conductor_channel_0(_S273, _S274.z, _S275.z).value0_37);
    return _S276;
}

struct Tuple_21
{
     value0_38 : f32,
};

struct Tuple_22
{
     value0_39 : f32,
};

fn s_apply_luminance_0( _S277 : vec3<f32>) -> Tuple_22
{
    var _S278 : Tuple_22;
    _S278.value0_39 = s_apply_dot_1(_S277, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f)).value0_14;
    return _S278;
}

fn s_apply_coat_eta_0( _S279 : Numbers_0) -> Tuple_21
{
    var _S280 : Tuple_21;
    _S280.value0_38 = s_apply_luminance_0(_S279.eta_0).value0_39 / s_apply_luminance_0(_S279.k_0).value0_39;
    return _S280;
}

struct Tuple_23
{
     value0_40 : f32,
     value1_8 : s_minCtx_s_bwdCallableCtx_transmittance_0,
};

struct Tuple_24
{
     value0_41 : f32,
};

fn s_apply_fresnel_dielectric_0( _S281 : f32,  _S282 : f32) -> Tuple_24
{
    var eta2_0 : f32 = _S282 * _S282;
    var cos2_2 : f32 = _S281 * _S281;
    var denser_0 : f32 = (_S282 - 1.0f) * (_S282 + 1.0f);
    var squared_0 : f32 = denser_0 + cos2_2;
    var _S283 : f32;
    if(!(squared_0 <= 0.0f))
    {
        var _S284 : Tuple_4 = s_apply_sqrt_0(squared_0);
        var s_sum_0 : f32 = _S281 + _S284.value0_6;
        var p_sum_1 : f32 = eta2_0 * _S281 + _S284.value0_6;
        var senkrecht_0 : f32 = denser_0 / (s_sum_0 * s_sum_0);
        var parallel_0 : f32 = denser_0 * ((eta2_0 + 1.0f) * cos2_2 - 1.0f) / (p_sum_1 * p_sum_1);
        _S283 = 0.5f * (senkrecht_0 * senkrecht_0 + parallel_0 * parallel_0);
    }
    else
    {
        _S283 = 1.0f;
    }
    var _S285 : Tuple_24;
    _S285.value0_41 = _S283;
    return _S285;
}

fn word_0( at_0 : u32) -> u32
{
    return scene_0[at_0];
}

fn number_0( at_1 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_1])));
}

fn s_apply_transmittance_0( lobe_2 : Lobe_0,  _S286 : f32,  _S287 : f32) -> Tuple_23
{
    var _S288 : s_minCtx_s_bwdCallableCtx_transmittance_0;
    _S288.value0_26 = 0.0f;
    _S288.value1_4 = 0.0f;
    var _S289 : bool = (lobe_2.kind_0) == u32(3);
    var _S290 : f32;
    if(_S289)
    {
        _S290 = 1.0f - s_apply_fresnel_dielectric_0(_S287, _S286).value0_41;
    }
    var _S291 : bool = !_S289;
    if(_S291)
    {
        var place_1 : f32 = _S287 * 63.0f;
        var _S292 : u32 = min(u32(place_1), u32(62));
        var at_2 : u32 = word_0(lobe_2.record_0 + u32(3)) + _S292;
        var here_0 : f32 = number_0(at_2);
        _S288.value0_26 = here_0;
        var next_0 : f32 = number_0(at_2 + u32(1));
        _S288.value1_4 = next_0;
        _S290 = here_0 + (next_0 - here_0) * (place_1 - f32(_S292));
    }
    var _S293 : Tuple_23;
    _S293.value0_40 = _S290;
    _S293.value1_8 = _S288;
    return _S293;
}

struct Tuple_25
{
     value0_42 : vec3<f32>,
     value1_9 : s_minCtx_s_bwdCallableCtx_base_0,
};

struct Tuple_26
{
     value0_43 : f32,
};

fn s_apply_fresnel_diffuse_0( _S294 : f32) -> Tuple_26
{
    var inverse_0 : f32 = 1.0f / _S294;
    var _S295 : bool = _S294 < 1.0f;
    var _S296 : f32;
    if(_S295)
    {
        _S296 = (-1.43990004062652588f * _S294 + 0.70990002155303955f) * _S294 + 0.66809999942779541f + 0.06360000371932983f * inverse_0;
    }
    var _S297 : bool = !_S295;
    if(_S297)
    {
        _S296 = ((((-1.36881005764007568f * inverse_0 + 4.98553991317749023f) * inverse_0 - 7.80988979339599609f) * inverse_0 + 6.75334978103637695f) * inverse_0 - 3.47930002212524414f) * inverse_0 + 0.91931700706481934f;
    }
    var _S298 : Tuple_26;
    _S298.value0_43 = _S296;
    return _S298;
}

fn s_apply_base_0( lobe_3 : Lobe_0,  _S299 : f32,  _S300 : vec3<f32>) -> Tuple_25
{
    var _S301 : s_minCtx_s_bwdCallableCtx_base_0;
    _S301.value0_27 = 0.0f;
    _S301.value1_5 = u32(0);
    var internal_reflectance_0 : f32;
    if((lobe_3.kind_0) == u32(3))
    {
        internal_reflectance_0 = s_apply_fresnel_diffuse_0(1.0f / _S299).value0_43;
    }
    else
    {
        var _S302 : f32 = number_0(word_0(lobe_3.record_0 + u32(3)) + u32(64));
        _S301.value0_27 = _S302;
        internal_reflectance_0 = _S302;
    }
    var _S303 : u32 = word_0(lobe_3.record_0 + u32(2));
    _S301.value1_5 = _S303;
    var _S304 : bool = _S303 == u32(0);
    var _S305 : vec3<f32>;
    if(_S304)
    {
        _S305 = _S300 * vec3<f32>((1.0f / (1.0f - internal_reflectance_0)));
    }
    var _S306 : bool = !_S304;
    if(_S306)
    {
        _S305 = _S300 / (vec3<f32>(1.0f) - _S300 * vec3<f32>(internal_reflectance_0));
    }
    var _S307 : Tuple_25;
    _S307.value0_42 = _S305;
    _S307.value1_9 = _S301;
    return _S307;
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

fn s_apply_scattering_0( lobe_4 : Lobe_0,  _S308 : Numbers_0,  _S309 : vec3<f32>,  _S310 : vec3<f32>) -> Tuple_12
{
    var _S311 : s_minCtx_s_bwdCallableCtx_transmittance_0 = s_minCtx_s_bwdCallableCtx_transmittance_0( 0.0f, 0.0f );
    var _S312 : vec3<f32> = vec3<f32>(0.0f);
    var _S313 : s_minCtx_s_bwdCallableCtx_base_0 = s_minCtx_s_bwdCallableCtx_base_0( 0.0f, u32(0) );
    var _S314 : s_minCtx_s_bwdCallableCtx_scattering_0;
    _S314.value0_28 = 0.0f;
    _S314.value1_6 = _S311;
    _S314.value2_1 = 0.0f;
    _S314.value3_0 = _S311;
    _S314.value4_0 = _S312;
    _S314.value5_0 = _S313;
    var _S315 : f32 = _S310.z;
    var by_cosine_0 : f32 = _S315 * 0.31830987334251404f;
    var _S316 : bool = (lobe_4.kind_0) == u32(0);
    var scattering_0 : Scattering_0;
    if(_S316)
    {
        scattering_0.value_1 = _S308.diffuse_reflectance_0 * vec3<f32>(by_cosine_0);
        scattering_0.pdf_0 = by_cosine_0;
    }
    var _S317 : bool = !_S316;
    if(_S317)
    {
        var _S318 : Tuple_13 = s_apply_Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
        var by_facets_0 : Mirrored_0;
        if(is_rough_0(lobe_4))
        {
            by_facets_0 = s_apply_mirrored_0(s_apply_facets_of_0(lobe_4, _S308).value0_31, _S309, _S310).value0_32;
        }
        else
        {
            by_facets_0 = _S318.value0_30;
        }
        var _runFlag_2 : bool;
        if((lobe_4.kind_0) == u32(2))
        {
            var _S319 : vec3<f32> = _S308.specular_reflectance_0 * (s_apply_fresnel_conductor_0(by_facets_0.cosine_0, _S308.eta_0, _S308.k_0).value0_36 * vec3<f32>(by_facets_0.scattered_0));
            _runFlag_2 = false;
            scattering_0.value_1 = _S319;
            scattering_0.pdf_0 = by_facets_0.pdf_1;
        }
        else
        {
            _runFlag_2 = _S317;
        }
        if(_runFlag_2)
        {
            var _S320 : Tuple_21 = s_apply_coat_eta_0(_S308);
            var _S321 : Tuple_23 = s_apply_transmittance_0(lobe_4, _S320.value0_38, _S309.z);
            _S314.value0_28 = _S321.value0_40;
            _S314.value1_6 = _S321.value1_8;
            var _S322 : Tuple_23 = s_apply_transmittance_0(lobe_4, _S320.value0_38, _S315);
            _S314.value2_1 = _S322.value0_40;
            _S314.value3_0 = _S322.value1_8;
            var _S323 : Tuple_25 = s_apply_base_0(lobe_4, _S320.value0_38, _S308.diffuse_reflectance_0);
            _S314.value4_0 = _S323.value0_42;
            _S314.value5_0 = _S323.value1_9;
            var _S324 : vec3<f32> = _S323.value0_42 * vec3<f32>((_S321.value0_40 * _S322.value0_40 * by_cosine_0 / (_S320.value0_38 * _S320.value0_38)));
            var probability_0 : f32 = base_probability_0(_S308, _S321.value0_40);
            var _S325 : f32 = probability_0 * by_cosine_0;
            if((lobe_4.kind_0) == u32(4))
            {
                var _S326 : f32 = _S325 + (1.0f - probability_0) * by_facets_0.pdf_1;
                scattering_0.value_1 = _S324 + _S308.specular_reflectance_0 * vec3<f32>((s_apply_fresnel_dielectric_0(by_facets_0.cosine_0, _S320.value0_38).value0_41 * by_facets_0.scattered_0));
                scattering_0.pdf_0 = _S326;
            }
            else
            {
                scattering_0.value_1 = _S324;
                scattering_0.pdf_0 = _S325;
            }
        }
    }
    var _S327 : Tuple_12;
    _S327.value0_29 = scattering_0;
    _S327.value1_7 = _S314;
    return _S327;
}

struct s_paramCtx_s_bwdCallableCtx_scattering_0
{
     value0_44 : Lobe_0,
     value1_10 : Numbers_0,
     value2_2 : vec3<f32>,
     value3_1 : vec3<f32>,
};

struct s_bwdCallableCtx_scattering_0
{
     value0_45 : s_paramCtx_s_bwdCallableCtx_scattering_0,
     value1_11 : s_minCtx_s_bwdCallableCtx_scattering_0,
};

struct s_paramCtx_s_bwdCallableCtx_facets_of_0
{
     value0_46 : Numbers_0,
};

struct s_paramCtx_s_bwdCallableCtx_mirrored_0
{
     value0_47 : Microfacets_0,
     value1_12 : vec3<f32>,
     value2_3 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0
{
     value0_48 : f32,
     value1_13 : vec3<f32>,
     value2_4 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_coat_eta_0
{
     value0_49 : Numbers_0,
};

struct s_paramCtx_s_bwdCallableCtx_transmittance_0
{
     value0_50 : Lobe_0,
     value1_14 : f32,
     value2_5 : f32,
};

struct s_paramCtx_s_bwdCallableCtx_base_0
{
     value0_51 : Lobe_0,
     value1_15 : f32,
     value2_6 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0
{
     value0_52 : f32,
     value1_16 : f32,
};

struct s_bwdCallableCtx_mirrored_0
{
     value0_53 : s_paramCtx_s_bwdCallableCtx_mirrored_0,
};

struct s_bwdCallableCtx_facets_of_0
{
     value0_54 : s_paramCtx_s_bwdCallableCtx_facets_of_0,
};

struct s_bwdCallableCtx_fresnel_conductor_0
{
     value0_55 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0,
};

struct s_bwdCallableCtx_fresnel_dielectric_0
{
     value0_56 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0,
};

struct s_bwdCallableCtx_base_0
{
     value0_57 : s_paramCtx_s_bwdCallableCtx_base_0,
     value1_17 : s_minCtx_s_bwdCallableCtx_base_0,
};

struct s_bwdCallableCtx_transmittance_0
{
     value0_58 : s_paramCtx_s_bwdCallableCtx_transmittance_0,
     value1_18 : s_minCtx_s_bwdCallableCtx_transmittance_0,
};

struct s_bwdCallableCtx_coat_eta_0
{
     value0_59 : s_paramCtx_s_bwdCallableCtx_coat_eta_0,
};

fn Numbers_x24_syn_dzero_0() -> Numbers_0
{
    var result_2 : Numbers_0;
    var _S328 : vec3<f32> = vec3<f32>(0.0f);
    result_2.diffuse_reflectance_0 = _S328;
    result_2.specular_reflectance_0 = _S328;
    result_2.eta_0 = _S328;
    result_2.k_0 = _S328;
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

fn s_bwdProp_fresnel_dielectric_0( _S329 : s_bwdCallableCtx_fresnel_dielectric_0,  _S330 : ptr<function, f32>,  _S331 : ptr<function, f32>,  _S332 : f32)
{
    var _S333 : f32 = _S329.value0_56.value1_16;
    var eta2_1 : f32 = _S333 * _S333;
    var _S334 : f32 = _S329.value0_56.value0_52;
    var cos2_3 : f32 = _S334 * _S334;
    var _S335 : f32 = _S329.value0_56.value1_16 - 1.0f;
    var _S336 : f32 = _S329.value0_56.value1_16 + 1.0f;
    var denser_1 : f32 = _S335 * _S336;
    var squared_1 : f32 = denser_1 + cos2_3;
    var _S337 : bool = !(squared_1 <= 0.0f);
    var _S338 : f32;
    var _S339 : f32;
    var _S340 : f32;
    var _S341 : f32;
    var _S342 : f32;
    var _S343 : f32;
    var _S344 : f32;
    var _S345 : f32;
    var _S346 : f32;
    var _S347 : f32;
    var _S348 : f32;
    var _S349 : s_bwdCallableCtx_sqrt_0;
    if(_S337)
    {
        var _S350 : Tuple_4 = s_apply_sqrt_0(squared_1);
        var _S351 : s_bwdCallableCtx_sqrt_0;
        _S351._S3 = squared_1;
        var s_sum_1 : f32 = _S329.value0_56.value0_52 + _S350.value0_6;
        var p_sum_2 : f32 = eta2_1 * _S329.value0_56.value0_52 + _S350.value0_6;
        var _S352 : f32 = s_sum_1 * s_sum_1;
        var senkrecht_1 : f32 = denser_1 / _S352;
        var _S353 : f32 = _S352 * _S352;
        var _S354 : f32 = eta2_1 + 1.0f;
        var _S355 : f32 = _S354 * cos2_3 - 1.0f;
        var _S356 : f32 = denser_1 * _S355;
        var _S357 : f32 = p_sum_2 * p_sum_2;
        var _S358 : f32 = _S357 * _S357;
        _S338 = _S356 / _S357;
        _S339 = senkrecht_1;
        _S340 = _S358;
        _S341 = _S356;
        _S342 = _S357;
        _S343 = p_sum_2;
        _S344 = _S355;
        _S345 = _S354;
        _S346 = _S353;
        _S347 = _S352;
        _S348 = s_sum_1;
        _S349 = _S351;
    }
    else
    {
        _S338 = 0.0f;
        _S339 = 0.0f;
        _S340 = 0.0f;
        _S341 = 0.0f;
        _S342 = 0.0f;
        _S343 = 0.0f;
        _S344 = 0.0f;
        _S345 = 0.0f;
        _S346 = 0.0f;
        _S347 = 0.0f;
        _S348 = 0.0f;
        _S349._S3 = 0.0f;
    }
    if(_S337)
    {
        var _S359 : f32 = 0.5f * _S332;
        var _S360 : f32 = _S338 * _S359;
        var _S361 : f32 = _S339 * _S359;
        var _S362 : f32 = (_S360 + _S360) / _S340;
        var _S363 : f32 = _S342 * _S362;
        var _S364 : f32 = _S343 * (_S341 * - _S362);
        var _S365 : f32 = denser_1 * _S363;
        var _S366 : f32 = _S344 * _S363;
        var _S367 : f32 = _S345 * _S365;
        var _S368 : f32 = cos2_3 * _S365;
        var _S369 : f32 = (_S361 + _S361) / _S346;
        var _S370 : f32 = _S347 * _S369;
        var _S371 : f32 = _S348 * (denser_1 * - _S369);
        var _S372 : f32 = _S364 + _S364;
        var _S373 : f32 = eta2_1 * _S372;
        var _S374 : f32 = _S329.value0_56.value0_52 * _S372;
        var _S375 : f32 = _S371 + _S371;
        var _S376 : f32 = _S372 + _S375;
        var _S377 : f32 = 0.0f;
        s_bwdProp_sqrt_0(_S349, &(_S377), _S376);
        var _S378 : f32 = _S368 + _S374;
        var _S379 : f32 = _S373 + _S375;
        var _S380 : f32 = _S366 + _S370;
        _S338 = _S377;
        _S339 = _S380;
        _S340 = _S367;
        _S341 = _S378;
        _S342 = _S379;
    }
    else
    {
        _S338 = 0.0f;
        _S339 = 0.0f;
        _S340 = 0.0f;
        _S341 = 0.0f;
        _S342 = 0.0f;
    }
    var _S381 : f32 = _S338 + _S339;
    var _S382 : f32 = _S329.value0_56.value0_52 * (_S338 + _S340);
    var _S383 : f32 = _S329.value0_56.value1_16 * _S341;
    var _S384 : f32 = _S335 * _S381 + _S336 * _S381 + _S383 + _S383;
    (*_S330) = _S382 + _S382 + _S342;
    (*_S331) = _S384;
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
     value0_60 : f32,
};

struct s_bwdCallableCtx_fresnel_diffuse_0
{
     value0_61 : s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0,
};

fn s_bwdProp_fresnel_diffuse_0( _S385 : s_bwdCallableCtx_fresnel_diffuse_0,  _S386 : ptr<function, f32>,  _S387 : f32)
{
    var inverse_1 : f32 = 1.0f / _S385.value0_61.value0_60;
    var _S388 : f32 = _S385.value0_61.value0_60 * _S385.value0_61.value0_60;
    var _S389 : bool = (_S385.value0_61.value0_60) < 1.0f;
    var _S390 : f32;
    if(_S389)
    {
        _S390 = -1.43990004062652588f * _S385.value0_61.value0_60 + 0.70990002155303955f;
    }
    else
    {
        _S390 = 0.0f;
    }
    var _S391 : bool = !_S389;
    var _S392 : f32;
    var _S393 : f32;
    var _S394 : f32;
    var _S395 : f32;
    if(_S391)
    {
        var _S396 : f32 = -1.36881005764007568f * inverse_1 + 4.98553991317749023f;
        var _S397 : f32 = _S396 * inverse_1 - 7.80988979339599609f;
        var sum_1 : f32 = _S397 * inverse_1 + 6.75334978103637695f;
        _S392 = sum_1 * inverse_1 - 3.47930002212524414f;
        _S393 = sum_1;
        _S394 = _S397;
        _S395 = _S396;
    }
    else
    {
        _S392 = 0.0f;
        _S393 = 0.0f;
        _S394 = 0.0f;
        _S395 = 0.0f;
    }
    if(_S391)
    {
        var _S398 : f32 = inverse_1 * _S387;
        var s_diff_sum_T_0 : f32 = inverse_1 * _S398;
        var _S399 : f32 = inverse_1 * s_diff_sum_T_0;
        var _S400 : f32 = _S392 * _S387 + _S393 * _S398 + _S394 * s_diff_sum_T_0 + _S395 * _S399 + -1.36881005764007568f * (inverse_1 * _S399);
        _S392 = 0.0f;
        _S393 = _S400;
    }
    else
    {
        _S392 = _S387;
        _S393 = 0.0f;
    }
    if(_S389)
    {
        var _S401 : f32 = _S390 * _S392 + -1.43990004062652588f * (_S385.value0_61.value0_60 * _S392);
        _S390 = 0.06360000371932983f * _S392 + _S393;
        _S392 = _S401;
    }
    else
    {
        _S390 = _S393;
        _S392 = 0.0f;
    }
    (*_S386) = - (_S390 / _S388) + _S392;
    return;
}

fn s_bwdProp_base_0( _S402 : s_bwdCallableCtx_base_0,  _S403 : ptr<function, f32>,  _S404 : ptr<function, vec3<f32>>,  _S405 : vec3<f32>)
{
    var _S406 : s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0 = s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0( 0.0f );
    var _S407 : vec3<f32> = vec3<f32>(0.0f);
    var _S408 : bool = (_S402.value0_57.value0_51.kind_0) == u32(3);
    var internal_reflectance_1 : f32;
    var _S409 : f32;
    var _S410 : s_bwdCallableCtx_fresnel_diffuse_0;
    if(_S408)
    {
        var _S411 : f32 = 1.0f / _S402.value0_57.value1_15;
        var _S412 : f32 = _S402.value0_57.value1_15 * _S402.value0_57.value1_15;
        var _S413 : Tuple_26 = s_apply_fresnel_diffuse_0(_S411);
        var _S414 : s_paramCtx_s_bwdCallableCtx_fresnel_diffuse_0;
        _S414.value0_60 = _S411;
        internal_reflectance_1 = _S413.value0_43;
        _S410.value0_61 = _S414;
        _S409 = _S412;
    }
    else
    {
        internal_reflectance_1 = _S402.value1_17.value0_27;
        _S410.value0_61 = _S406;
        _S409 = 0.0f;
    }
    var _S415 : vec3<f32> = vec3<f32>(internal_reflectance_1);
    var _S416 : bool = (_S402.value1_17.value1_5) == u32(0);
    var _S417 : f32;
    var _S418 : vec3<f32>;
    if(_S416)
    {
        var _S419 : f32 = 1.0f - internal_reflectance_1;
        var _S420 : f32 = _S419 * _S419;
        _S418 = vec3<f32>((1.0f / _S419));
        _S417 = _S420;
    }
    else
    {
        _S418 = _S407;
        _S417 = 0.0f;
    }
    var _S421 : bool = !_S416;
    var _S422 : vec3<f32>;
    var _S423 : vec3<f32>;
    if(_S421)
    {
        var _S424 : vec3<f32> = vec3<f32>(1.0f) - _S402.value0_57.value2_6 * vec3<f32>(internal_reflectance_1);
        _S422 = _S424 * _S424;
        _S423 = _S424;
    }
    else
    {
        _S422 = _S407;
        _S423 = _S407;
    }
    var _S425 : vec3<f32>;
    if(_S421)
    {
        var _S426 : vec3<f32> = _S405 / _S422;
        var _S427 : vec3<f32> = (vec3<f32>(0) - _S402.value0_57.value2_6 * (vec3<f32>(0) - _S426));
        var _S428 : vec3<f32> = _S402.value0_57.value2_6 * _S427;
        var _S429 : vec3<f32> = _S423 * _S426 + _S415 * _S427;
        _S422 = _S407;
        _S423 = _S429;
        _S425 = _S428;
    }
    else
    {
        _S422 = _S405;
        _S423 = _S407;
        _S425 = _S407;
    }
    if(_S416)
    {
        var _S430 : vec3<f32> = _S402.value0_57.value2_6 * _S422;
        var _S431 : vec3<f32> = _S418 * _S422 + _S423;
        internal_reflectance_1 = - - ((_S430[i32(0)] + _S430[i32(1)] + _S430[i32(2)]) / _S417);
        _S418 = _S431;
    }
    else
    {
        internal_reflectance_1 = 0.0f;
        _S418 = _S423;
    }
    var _S432 : f32 = _S425[i32(0)] + _S425[i32(1)] + _S425[i32(2)] + internal_reflectance_1;
    if(_S408)
    {
        var _S433 : f32 = 0.0f;
        s_bwdProp_fresnel_diffuse_0(_S410, &(_S433), _S432);
        internal_reflectance_1 = - (_S433 / _S409);
    }
    else
    {
        internal_reflectance_1 = 0.0f;
    }
    (*_S403) = internal_reflectance_1;
    (*_S404) = _S418;
    return;
}

fn s_bwdProp_transmittance_0( _S434 : s_bwdCallableCtx_transmittance_0,  _S435 : ptr<function, f32>,  _S436 : ptr<function, f32>,  _S437 : f32)
{
    var _S438 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0 = s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0( 0.0f, 0.0f );
    var _S439 : bool = (_S434.value0_58.value0_50.kind_0) == u32(3);
    var _S440 : s_bwdCallableCtx_fresnel_dielectric_0;
    if(_S439)
    {
        var _S441 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0;
        _S441.value0_52 = _S434.value0_58.value2_5;
        _S441.value1_16 = _S434.value0_58.value1_14;
        _S440.value0_56 = _S441;
    }
    else
    {
        _S440.value0_56 = _S438;
    }
    var _S442 : bool = !_S439;
    var _S443 : f32;
    if(_S442)
    {
        _S443 = _S434.value1_18.value1_4 - _S434.value1_18.value0_26;
    }
    else
    {
        _S443 = 0.0f;
    }
    var _S444 : f32;
    if(_S442)
    {
        var _S445 : f32 = 63.0f * (_S443 * _S437);
        _S443 = 0.0f;
        _S444 = _S445;
    }
    else
    {
        _S443 = _S437;
        _S444 = 0.0f;
    }
    if(_S439)
    {
        var _S446 : f32 = - _S443;
        var _S447 : f32 = 0.0f;
        var _S448 : f32 = 0.0f;
        s_bwdProp_fresnel_dielectric_0(_S440, &(_S447), &(_S448), _S446);
        var _S449 : f32 = _S447 + _S444;
        _S443 = _S448;
        _S444 = _S449;
    }
    else
    {
        _S443 = 0.0f;
    }
    (*_S435) = _S443;
    (*_S436) = _S444;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_luminance_0
{
     value0_62 : vec3<f32>,
};

struct s_bwdCallableCtx_luminance_0
{
     value0_63 : s_paramCtx_s_bwdCallableCtx_luminance_0,
};

fn s_bwdProp_luminance_0( _S450 : s_bwdCallableCtx_luminance_0,  _S451 : ptr<function, vec3<f32>>,  _S452 : f32)
{
    var _S453 : s_bwdCallableCtx_dot_1;
    _S453._S108 = _S450.value0_63.value0_62;
    _S453._S109 = vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f);
    var _S454 : vec3<f32> = vec3<f32>(0.0f);
    var _S455 : vec3<f32> = _S454;
    var _S456 : vec3<f32> = _S454;
    s_bwdProp_dot_1(_S453, &(_S455), &(_S456), _S452);
    (*_S451) = _S455;
    return;
}

fn s_bwdProp_coat_eta_0( _S457 : s_bwdCallableCtx_coat_eta_0,  _S458 : ptr<function, Numbers_0>,  _S459 : f32)
{
    var _S460 : Tuple_22 = s_apply_luminance_0(_S457.value0_59.value0_49.eta_0);
    var _S461 : s_paramCtx_s_bwdCallableCtx_luminance_0;
    _S461.value0_62 = _S457.value0_59.value0_49.eta_0;
    var _S462 : s_bwdCallableCtx_luminance_0 = s_bwdCallableCtx_luminance_0( _S461 );
    var _S463 : Tuple_22 = s_apply_luminance_0(_S457.value0_59.value0_49.k_0);
    var _S464 : s_paramCtx_s_bwdCallableCtx_luminance_0;
    _S464.value0_62 = _S457.value0_59.value0_49.k_0;
    var _S465 : s_bwdCallableCtx_luminance_0 = s_bwdCallableCtx_luminance_0( _S464 );
    var _S466 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S467 : f32 = _S459 / (_S463.value0_39 * _S463.value0_39);
    var _S468 : f32 = _S460.value0_39 * - _S467;
    var _S469 : f32 = _S463.value0_39 * _S467;
    var _S470 : vec3<f32> = vec3<f32>(0.0f);
    var _S471 : vec3<f32> = _S470;
    s_bwdProp_luminance_0(_S465, &(_S471), _S468);
    var _S472 : vec3<f32> = _S470;
    s_bwdProp_luminance_0(_S462, &(_S472), _S469);
    var _S473 : Numbers_0 = _S466;
    _S473.k_0 = _S471;
    _S473.eta_0 = _S472;
    (*_S458) = Numbers_x24_syn_dadd_0(_S466, _S473);
    return;
}

struct s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0
{
     value0_64 : f32,
     value1_19 : f32,
     value2_7 : f32,
};

struct s_bwdCallableCtx_fresnel_conductor_channel_0
{
     value0_65 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0,
};

fn s_bwdProp_fresnel_conductor_channel_0( _S474 : s_bwdCallableCtx_fresnel_conductor_channel_0,  _S475 : ptr<function, f32>,  _S476 : ptr<function, f32>,  _S477 : ptr<function, f32>,  _S478 : f32)
{
    var _S479 : f32 = _S474.value0_65.value0_64;
    var cos2_4 : f32 = _S479 * _S479;
    var sin2_1 : f32 = 1.0f - cos2_4;
    var _S480 : f32 = _S474.value0_65.value1_19;
    var _S481 : f32 = _S474.value0_65.value2_7;
    var real_1 : f32 = _S480 * _S480 - _S481 * _S481 - sin2_1;
    var product_1 : f32 = _S474.value0_65.value1_19 * _S474.value0_65.value2_7;
    var _S482 : f32 = real_1 * real_1 + 4.0f * (product_1 * product_1);
    var _S483 : Tuple_4 = s_apply_sqrt_0(_S482);
    var _S484 : s_bwdCallableCtx_sqrt_0;
    _S484._S3 = _S482;
    var _S485 : s_bwdCallableCtx_sqrt_0 = _S484;
    var _S486 : bool = !((_S483.value0_6) == 0.0f);
    var a_3 : f32;
    var b_2 : f32;
    var _S487 : f32;
    var _S488 : f32;
    var _S489 : f32;
    var _S490 : f32;
    var _S491 : f32;
    var _S492 : f32;
    var _S493 : f32;
    var _S494 : f32;
    var _S495 : f32;
    var _S496 : f32;
    var _S497 : f32;
    var _S498 : f32;
    var _S499 : f32;
    var _S500 : bool;
    var _S501 : s_bwdCallableCtx_sqrt_0;
    var _S502 : s_bwdCallableCtx_abs_0;
    if(_S486)
    {
        var _S503 : Tuple_10 = s_apply_abs_0(real_1);
        var _S504 : s_bwdCallableCtx_abs_0;
        _S504._S118 = real_1;
        var _S505 : s_bwdCallableCtx_abs_0 = _S504;
        var _S506 : f32 = 0.5f * (_S483.value0_6 + _S503.value0_16);
        var _S507 : Tuple_4 = s_apply_sqrt_0(_S506);
        var _S508 : s_bwdCallableCtx_sqrt_0;
        _S508._S3 = _S506;
        var _S509 : s_bwdCallableCtx_sqrt_0 = _S508;
        var smaller_1 : f32 = product_1 / _S507.value0_6;
        var _S510 : f32 = _S507.value0_6 * _S507.value0_6;
        var _S511 : bool = real_1 < 0.0f;
        if(_S511)
        {
            a_3 = smaller_1;
        }
        else
        {
            a_3 = _S507.value0_6;
        }
        if(_S511)
        {
            b_2 = _S507.value0_6;
        }
        else
        {
            b_2 = smaller_1;
        }
        var less_1 : f32 = a_3 - _S474.value0_65.value0_64;
        var more_1 : f32 = a_3 + _S474.value0_65.value0_64;
        var _S512 : f32 = b_2 * b_2;
        var _S513 : f32 = less_1 * less_1 + _S512;
        var _S514 : f32 = more_1 * more_1 + _S512;
        var senkrecht_2 : f32 = _S513 / _S514;
        var _S515 : f32 = _S514 * _S514;
        var p_sum_3 : f32 = _S483.value0_6 * cos2_4 + sin2_1 * sin2_1;
        var _S516 : f32 = senkrecht_2 * p_sum_3;
        var _S517 : f32 = 2.0f * a_3;
        var _S518 : f32 = _S517 * _S474.value0_65.value0_64;
        var _S519 : f32 = p_sum_3 + _S518 * sin2_1;
        var _S520 : f32 = b_2;
        a_3 = _S519 * _S519;
        b_2 = _S516;
        _S487 = _S519;
        _S488 = _S518;
        _S489 = _S517;
        _S490 = senkrecht_2;
        _S491 = p_sum_3;
        _S492 = _S515;
        _S493 = _S513;
        _S494 = _S514;
        _S495 = more_1;
        _S496 = _S520;
        _S497 = less_1;
        _S500 = _S511;
        _S498 = _S510;
        _S499 = _S507.value0_6;
        _S501 = _S509;
        _S502 = _S505;
    }
    else
    {
        a_3 = 0.0f;
        b_2 = 0.0f;
        _S487 = 0.0f;
        _S488 = 0.0f;
        _S489 = 0.0f;
        _S490 = 0.0f;
        _S491 = 0.0f;
        _S492 = 0.0f;
        _S493 = 0.0f;
        _S494 = 0.0f;
        _S495 = 0.0f;
        _S496 = 0.0f;
        _S497 = 0.0f;
        _S500 = false;
        _S498 = 0.0f;
        _S499 = 0.0f;
        _S501._S3 = 0.0f;
        _S502._S118 = 0.0f;
    }
    if(_S486)
    {
        var _S521 : f32 = _S478 / a_3;
        var _S522 : f32 = b_2 * - _S521;
        var _S523 : f32 = _S487 * _S521;
        var _S524 : f32 = sin2_1 * _S522;
        var _S525 : f32 = _S522 + _S490 * _S523;
        var _S526 : f32 = sin2_1 * _S525;
        var _S527 : f32 = _S483.value0_6 * _S525;
        var _S528 : f32 = cos2_4 * _S525;
        var _S529 : f32 = _S491 * _S523 / _S492;
        var _S530 : f32 = _S493 * - _S529;
        var _S531 : f32 = _S494 * _S529;
        var _S532 : f32 = _S495 * _S530;
        var _S533 : f32 = _S496 * (_S530 + _S531);
        var _S534 : f32 = _S497 * _S531;
        var _S535 : f32 = _S532 + _S532;
        var _S536 : f32 = _S534 + _S534;
        var _S537 : f32 = _S533 + _S533;
        var _S538 : f32 = 2.0f * (_S474.value0_65.value0_64 * _S524) + _S535 + _S536;
        var _S539 : f32 = _S488 * _S522 + _S526 + _S526;
        var _S540 : f32 = _S489 * _S524 + _S535 + - _S536;
        if(_S500)
        {
            a_3 = 0.0f;
            b_2 = _S537;
        }
        else
        {
            a_3 = _S537;
            b_2 = 0.0f;
        }
        if(_S500)
        {
            a_3 = _S538 + a_3;
        }
        else
        {
            b_2 = _S538 + b_2;
        }
        var _S541 : f32 = a_3 / _S498;
        var _S542 : f32 = _S499 * _S541;
        var _S543 : f32 = product_1 * - _S541 + b_2;
        var _S544 : f32 = 0.0f;
        s_bwdProp_sqrt_0(_S501, &(_S544), _S543);
        var _S545 : f32 = 0.5f * _S544;
        var _S546 : f32 = 0.0f;
        s_bwdProp_abs_0(_S502, &(_S546), _S545);
        a_3 = _S545 + _S528;
        b_2 = _S542;
        _S487 = _S546;
        _S488 = _S539;
        _S489 = _S527;
        _S490 = _S540;
    }
    else
    {
        a_3 = 0.0f;
        b_2 = 0.0f;
        _S487 = 0.0f;
        _S488 = 0.0f;
        _S489 = 0.0f;
        _S490 = 0.0f;
    }
    var _S547 : f32 = 0.0f;
    s_bwdProp_sqrt_0(_S485, &(_S547), a_3);
    var _S548 : f32 = product_1 * (4.0f * _S547);
    var _S549 : f32 = real_1 * _S547;
    var _S550 : f32 = _S548 + _S548 + b_2;
    var _S551 : f32 = _S549 + _S549 + _S487;
    var _S552 : f32 = - _S551;
    var _S553 : f32 = _S474.value0_65.value2_7 * _S552;
    var _S554 : f32 = _S474.value0_65.value1_19 * _S551;
    var _S555 : f32 = _S474.value0_65.value0_64 * (- (_S552 + _S488) + _S489);
    var _S556 : f32 = _S474.value0_65.value2_7 * _S550 + _S554 + _S554;
    var _S557 : f32 = _S474.value0_65.value1_19 * _S550 + _S553 + _S553;
    (*_S475) = _S555 + _S555 + _S490;
    (*_S476) = _S556;
    (*_S477) = _S557;
    return;
}

fn s_bwdProp_fresnel_conductor_0( _S558 : s_bwdCallableCtx_fresnel_conductor_0,  _S559 : ptr<function, f32>,  _S560 : ptr<function, vec3<f32>>,  _S561 : ptr<function, vec3<f32>>,  _S562 : vec3<f32>)
{
    var _S563 : f32 = _S558.value0_55.value1_13.x;
    var _S564 : f32 = _S558.value0_55.value2_4.x;
    var _S565 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0;
    _S565.value0_64 = _S558.value0_55.value0_48;
    _S565.value1_19 = _S563;
    _S565.value2_7 = _S564;
    var _S566 : s_bwdCallableCtx_fresnel_conductor_channel_0 = s_bwdCallableCtx_fresnel_conductor_channel_0( _S565 );
    var _S567 : f32 = _S558.value0_55.value1_13.y;
    var _S568 : f32 = _S558.value0_55.value2_4.y;
    var _S569 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0;
    _S569.value0_64 = _S558.value0_55.value0_48;
    _S569.value1_19 = _S567;
    _S569.value2_7 = _S568;
    var _S570 : s_bwdCallableCtx_fresnel_conductor_channel_0 = s_bwdCallableCtx_fresnel_conductor_channel_0( _S569 );
    var _S571 : f32 = _S558.value0_55.value1_13.z;
    var _S572 : f32 = _S558.value0_55.value2_4.z;
    var _S573 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_channel_0;
    _S573.value0_64 = _S558.value0_55.value0_48;
    _S573.value1_19 = _S571;
    _S573.value2_7 = _S572;
    var _S574 : s_bwdCallableCtx_fresnel_conductor_channel_0 = s_bwdCallableCtx_fresnel_conductor_channel_0( _S573 );
    var _S575 : f32 = 0.0f;
    var _S576 : f32 = 0.0f;
    var _S577 : f32 = 0.0f;
    s_bwdProp_fresnel_conductor_channel_0(_S574, &(_S575), &(_S576), &(_S577), _S562[i32(2)]);
    var _S578 : f32 = 0.0f;
    var _S579 : f32 = 0.0f;
    var _S580 : f32 = 0.0f;
    s_bwdProp_fresnel_conductor_channel_0(_S570, &(_S578), &(_S579), &(_S580), _S562[i32(1)]);
    var _S581 : f32 = 0.0f;
    var _S582 : f32 = 0.0f;
    var _S583 : f32 = 0.0f;
    s_bwdProp_fresnel_conductor_channel_0(_S566, &(_S581), &(_S582), &(_S583), _S562[i32(0)]);
    var _S584 : vec3<f32> = vec3<f32>(_S583, _S580, _S577);
    var _S585 : vec3<f32> = vec3<f32>(_S582, _S579, _S576);
    (*_S559) = _S575 + _S578 + _S581;
    (*_S560) = _S585;
    (*_S561) = _S584;
    return;
}

struct Microfacets_Differential_0
{
     alpha_2 : vec2<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_density_0
{
     value0_66 : Microfacets_0,
     value1_20 : vec3<f32>,
};

struct s_bwdCallableCtx_density_0
{
     value0_67 : s_paramCtx_s_bwdCallableCtx_density_0,
};

struct s_paramCtx_s_bwdCallableCtx_visible_over_cos_0
{
     value0_68 : Microfacets_0,
     value1_21 : vec3<f32>,
};

struct s_bwdCallableCtx_visible_over_cos_0
{
     value0_69 : s_paramCtx_s_bwdCallableCtx_visible_over_cos_0,
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

fn s_bwdProp_visible_over_cos_0( _S586 : s_bwdCallableCtx_visible_over_cos_0,  _S587 : ptr<function, Microfacets_Differential_0>,  _S588 : ptr<function, vec3<f32>>,  _S589 : f32)
{
    var _S590 : vec2<f32> = _S586.value0_69.value1_21.xy;
    var stretched_1 : vec2<f32> = _S590 * _S586.value0_69.value0_68.alpha_1;
    var _S591 : Tuple_2 = s_apply_dot_0(stretched_1, stretched_1);
    var _S592 : s_bwdCallableCtx_dot_0;
    _S592._S35 = stretched_1;
    _S592._S36 = stretched_1;
    var _S593 : s_bwdCallableCtx_dot_0 = _S592;
    var _S594 : f32 = _S586.value0_69.value1_21.z;
    var z2_1 : f32 = _S594 * _S594;
    var _S595 : bool = (_S586.value0_69.value0_68.distribution_1) == u32(1);
    var _S596 : f32;
    var _S597 : s_bwdCallableCtx_sqrt_0;
    if(_S595)
    {
        var _S598 : f32 = z2_1 + _S591.value0_4;
        var _S599 : Tuple_4 = s_apply_sqrt_0(_S598);
        var _S600 : s_bwdCallableCtx_sqrt_0;
        _S600._S3 = _S598;
        var _S601 : f32 = _S594 + _S599.value0_6;
        _S596 = _S601 * _S601;
        _S597 = _S600;
    }
    else
    {
        _S596 = 0.0f;
        _S597._S3 = 0.0f;
    }
    var _S602 : bool = !_S595;
    var _S603 : f32;
    var _S604 : f32;
    var _S605 : f32;
    var _S606 : f32;
    var _S607 : f32;
    var _S608 : f32;
    var _S609 : f32;
    var _S610 : s_bwdCallableCtx_sqrt_0;
    var _runFlag_3 : bool;
    var _S611 : bool;
    var _S612 : s_bwdCallableCtx_error_function_plus_one_0;
    if(_S602)
    {
        var _S613 : bool = z2_1 >= (36.0f * _S591.value0_4);
        if(_S613)
        {
            _runFlag_3 = false;
            _S603 = z2_1;
        }
        else
        {
            _runFlag_3 = _S602;
            _S603 = 0.0f;
        }
        if(_runFlag_3)
        {
            var _S614 : Tuple_4 = s_apply_sqrt_0(_S591.value0_4);
            var _S615 : s_bwdCallableCtx_sqrt_0;
            _S615._S3 = _S591.value0_4;
            var _S616 : f32 = _S594 / _S614.value0_6;
            var _S617 : f32 = _S614.value0_6 * _S614.value0_6;
            var _S618 : Tuple_1 = s_apply_error_function_plus_one_0(_S616);
            var _S619 : s_bwdCallableCtx_error_function_plus_one_0;
            _S619._S31 = _S616;
            var _S620 : f32 = _S618.value0_3.x;
            var _S621 : f32 = 0.5f * _S614.value0_6;
            var _S622 : f32 = _S618.value0_3.y;
            var _S623 : f32 = _S594 * _S620 + _S621 * _S622;
            _S604 = _S623 * _S623;
            _S605 = _S621;
            _S606 = _S622;
            _S607 = _S620;
            _S612 = _S619;
            _S608 = _S617;
            _S609 = _S614.value0_6;
            _S610 = _S615;
        }
        else
        {
            _S604 = 0.0f;
            _S605 = 0.0f;
            _S606 = 0.0f;
            _S607 = 0.0f;
            _S612._S31 = 0.0f;
            _S608 = 0.0f;
            _S609 = 0.0f;
            _S610._S3 = 0.0f;
        }
        var _S624 : f32 = _S603;
        _S603 = _S604;
        _S604 = _S605;
        _S605 = _S606;
        _S606 = _S607;
        _S607 = _S608;
        _S608 = _S609;
        _S611 = _S613;
        _S609 = _S624;
    }
    else
    {
        _runFlag_3 = false;
        _S603 = 0.0f;
        _S604 = 0.0f;
        _S605 = 0.0f;
        _S606 = 0.0f;
        _S612._S31 = 0.0f;
        _S607 = 0.0f;
        _S608 = 0.0f;
        _S610._S3 = 0.0f;
        _S611 = false;
        _S609 = 0.0f;
    }
    var _S625 : Microfacets_Differential_0 = Microfacets_x24_syn_dzero_0();
    if(_S602)
    {
        if(_runFlag_3)
        {
            var _S626 : f32 = 2.0f * - (_S589 / _S603);
            var _S627 : f32 = 0.5f * (_S605 * _S626);
            var _S628 : f32 = _S606 * _S626;
            var _S629 : vec2<f32> = vec2<f32>(_S594 * _S626, _S604 * _S626);
            var _S630 : f32 = 0.0f;
            s_bwdProp_error_function_plus_one_0(_S612, &(_S630), _S629);
            var _S631 : f32 = _S630 / _S607;
            var _S632 : f32 = _S608 * _S631;
            var _S633 : f32 = _S627 + _S594 * - _S631;
            var _S634 : f32 = 0.0f;
            s_bwdProp_sqrt_0(_S610, &(_S634), _S633);
            var _S635 : f32 = _S628 + _S632;
            _S603 = 0.0f;
            _S604 = _S635;
            _S605 = _S634;
        }
        else
        {
            _S603 = _S589;
            _S604 = 0.0f;
            _S605 = 0.0f;
        }
        if(_S611)
        {
            var _S636 : f32 = - (_S603 / _S609) + _S604;
            _S603 = 0.0f;
            _S604 = _S636;
        }
    }
    else
    {
        _S603 = _S589;
        _S604 = 0.0f;
        _S605 = 0.0f;
    }
    if(_S595)
    {
        var _S637 : f32 = 2.0f * - (_S603 / _S596);
        var _S638 : f32 = 0.0f;
        s_bwdProp_sqrt_0(_S597, &(_S638), _S637);
        var _S639 : f32 = _S637 + _S604;
        var _S640 : f32 = _S638 + _S605;
        _S596 = _S638;
        _S603 = _S639;
        _S604 = _S640;
    }
    else
    {
        _S596 = 0.0f;
        _S603 = _S604;
        _S604 = _S605;
    }
    var _S641 : f32 = _S594 * _S596;
    var _S642 : f32 = _S641 + _S641 + _S603;
    var _S643 : vec2<f32> = vec2<f32>(0.0f);
    var _S644 : vec2<f32> = _S643;
    var _S645 : vec2<f32> = _S643;
    s_bwdProp_dot_0(_S593, &(_S644), &(_S645), _S604);
    var _S646 : vec2<f32> = _S644 + _S645;
    var _S647 : vec2<f32> = _S590 * _S646;
    var _S648 : vec2<f32> = _S586.value0_69.value0_68.alpha_1 * _S646;
    var _S649 : vec3<f32> = vec3<f32>(_S648[i32(0)], _S648[i32(1)], _S642);
    var _S650 : Microfacets_Differential_0 = _S625;
    _S650.alpha_2 = _S647;
    (*_S587) = Microfacets_x24_syn_dadd_0(_S625, _S650);
    (*_S588) = _S649;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_exponential_0
{
     value0_70 : f32,
};

struct s_bwdCallableCtx_exponential_0
{
     value0_71 : s_paramCtx_s_bwdCallableCtx_exponential_0,
};

fn s_bwdProp_exponential_0( _S651 : s_bwdCallableCtx_exponential_0,  _S652 : ptr<function, f32>,  _S653 : f32)
{
    var _S654 : bool = !((_S651.value0_71.value0_70) < -87.0f);
    var _S655 : f32;
    var _S656 : f32;
    var _S657 : f32;
    var _S658 : f32;
    var _S659 : f32;
    var _S660 : f32;
    var _S661 : f32;
    var _S662 : f32;
    if(_S654)
    {
        var power_2 : f32 = floor(_S651.value0_71.value0_70 * 1.4426950216293335f + 0.5f);
        var r_2 : f32 = _S651.value0_71.value0_70 - power_2 * 0.693359375f + power_2 * 0.00021219444170129f;
        var _S663 : f32 = 0.00019875691214111f * r_2 + 0.00139819993637502f;
        var _S664 : f32 = _S663 * r_2 + 0.00833345204591751f;
        var tail_0 : f32 = _S664 * r_2 + 0.04166579619050026f;
        var _S665 : f32 = tail_0 * r_2 + 0.1666666567325592f;
        var tail_1 : f32 = _S665 * r_2 + 0.5f;
        var _S666 : f32 = tail_1 * r_2;
        _S655 = (bitcast<f32>(((u32(i32(power_2) + i32(127)) << (u32(23))))));
        _S656 = _S666;
        _S657 = r_2;
        _S658 = tail_1;
        _S659 = _S665;
        _S660 = tail_0;
        _S661 = _S664;
        _S662 = _S663;
    }
    else
    {
        _S655 = 0.0f;
        _S656 = 0.0f;
        _S657 = 0.0f;
        _S658 = 0.0f;
        _S659 = 0.0f;
        _S660 = 0.0f;
        _S661 = 0.0f;
        _S662 = 0.0f;
    }
    if(_S654)
    {
        var _S667 : f32 = _S655 * _S653;
        var _S668 : f32 = _S657 * _S667;
        var s_diff_tail_T_0 : f32 = _S657 * _S668;
        var _S669 : f32 = _S657 * s_diff_tail_T_0;
        var s_diff_tail_T_1 : f32 = _S657 * _S669;
        var _S670 : f32 = _S657 * s_diff_tail_T_1;
        _S655 = _S667 + _S656 * _S667 + _S658 * _S668 + _S659 * s_diff_tail_T_0 + _S660 * _S669 + _S661 * s_diff_tail_T_1 + _S662 * _S670 + 0.00019875691214111f * (_S657 * _S670);
    }
    else
    {
        _S655 = 0.0f;
    }
    (*_S652) = _S655;
    return;
}

fn s_bwdProp_density_0( _S671 : s_bwdCallableCtx_density_0,  _S672 : ptr<function, Microfacets_Differential_0>,  _S673 : ptr<function, vec3<f32>>,  _S674 : f32)
{
    var _S675 : vec2<f32> = vec2<f32>(0.0f);
    var _S676 : s_paramCtx_s_bwdCallableCtx_exponential_0 = s_paramCtx_s_bwdCallableCtx_exponential_0( 0.0f );
    var _S677 : f32 = _S671.value0_67.value1_20.z;
    var _S678 : bool = !(_S677 <= 0.0f);
    var _runFlag_4 : bool;
    var _S679 : bool;
    var _S680 : bool;
    var _S681 : f32;
    var _S682 : f32;
    var _S683 : f32;
    var _S684 : f32;
    var _S685 : f32;
    var _S686 : f32;
    var _S687 : f32;
    var _S688 : f32;
    var _S689 : f32;
    var _S690 : f32;
    var _S691 : f32;
    var _S692 : f32;
    var _S693 : f32;
    var _S694 : s_bwdCallableCtx_exponential_0;
    var _S695 : s_bwdCallableCtx_dot_0;
    var _S696 : vec2<f32>;
    var _S697 : vec2<f32>;
    var _S698 : vec2<f32>;
    if(_S678)
    {
        var _S699 : f32 = 3.14159274101257324f * _S671.value0_67.value0_66.alpha_1.x;
        var _S700 : f32 = _S671.value0_67.value0_66.alpha_1.y;
        var scale_1 : f32 = _S699 * _S700;
        var _S701 : vec2<f32> = _S671.value0_67.value1_20.xy;
        var slope_2 : vec2<f32> = _S701 / _S671.value0_67.value0_66.alpha_1;
        var _S702 : vec2<f32> = _S671.value0_67.value0_66.alpha_1 * _S671.value0_67.value0_66.alpha_1;
        var _S703 : Tuple_2 = s_apply_dot_0(slope_2, slope_2);
        var _S704 : s_bwdCallableCtx_dot_0;
        _S704._S35 = slope_2;
        _S704._S36 = slope_2;
        var _S705 : s_bwdCallableCtx_dot_0 = _S704;
        var cos2_5 : f32 = _S677 * _S677;
        var _S706 : bool = (_S671.value0_67.value0_66.distribution_1) == u32(1);
        if(_S706)
        {
            var sum_2 : f32 = _S703.value0_4 + cos2_5;
            var _S707 : f32 = scale_1 * sum_2;
            var _S708 : f32 = _S707 * sum_2;
            var _S709 : f32 = _S708 * _S708;
            _runFlag_4 = false;
            _S681 = _S709;
            _S682 = _S707;
            _S683 = sum_2;
        }
        else
        {
            _runFlag_4 = _S678;
            _S681 = 0.0f;
            _S682 = 0.0f;
            _S683 = 0.0f;
        }
        if(_runFlag_4)
        {
            var exponent_1 : f32 = _S703.value0_4 / cos2_5;
            var _S710 : f32 = cos2_5 * cos2_5;
            var _S711 : bool = exponent_1 > 80.0f;
            if(_S711)
            {
                _S684 = 0.0f;
                _S685 = 0.0f;
                _S686 = 0.0f;
                _S687 = 0.0f;
                _S694.value0_71 = _S676;
            }
            else
            {
                var _S712 : f32 = - exponent_1;
                var _S713 : Tuple_17 = s_apply_exponential_0(_S712);
                var _S714 : s_paramCtx_s_bwdCallableCtx_exponential_0;
                _S714.value0_70 = _S712;
                var _S715 : f32 = scale_1 * cos2_5;
                var _S716 : f32 = _S715 * cos2_5;
                _S684 = _S716 * _S716;
                _S685 = _S713.value0_34;
                _S686 = _S716;
                _S687 = _S715;
                _S694.value0_71 = _S714;
            }
            _S679 = _S711;
            _S688 = _S710;
        }
        else
        {
            _S679 = false;
            _S684 = 0.0f;
            _S685 = 0.0f;
            _S686 = 0.0f;
            _S687 = 0.0f;
            _S694.value0_71 = _S676;
            _S688 = 0.0f;
        }
        var _S717 : f32 = _S681;
        var _S718 : f32 = _S682;
        var _S719 : f32 = _S683;
        _S681 = _S684;
        _S682 = _S685;
        _S683 = _S686;
        _S684 = _S687;
        _S685 = cos2_5;
        _S686 = scale_1;
        _S687 = _S688;
        _S688 = _S703.value0_4;
        _S680 = _S706;
        _S689 = _S717;
        _S690 = _S718;
        _S691 = _S719;
        _S695 = _S705;
        _S696 = _S702;
        _S697 = _S701;
        _S698 = _S671.value0_67.value0_66.alpha_1;
        _S692 = _S699;
        _S693 = _S700;
    }
    else
    {
        _runFlag_4 = false;
        _S679 = false;
        _S681 = 0.0f;
        _S682 = 0.0f;
        _S683 = 0.0f;
        _S684 = 0.0f;
        _S685 = 0.0f;
        _S686 = 0.0f;
        _S694.value0_71 = _S676;
        _S687 = 0.0f;
        _S688 = 0.0f;
        _S680 = false;
        _S689 = 0.0f;
        _S690 = 0.0f;
        _S691 = 0.0f;
        _S695._S35 = _S675;
        _S695._S36 = _S675;
        _S696 = _S675;
        _S697 = _S675;
        _S698 = _S675;
        _S692 = 0.0f;
        _S693 = 0.0f;
    }
    var _S720 : Microfacets_Differential_0 = Microfacets_x24_syn_dzero_0();
    var _S721 : vec3<f32> = vec3<f32>(0.0f);
    var _S722 : vec3<f32>;
    var _S723 : Microfacets_Differential_0;
    if(_S678)
    {
        if(_runFlag_4)
        {
            if(_S679)
            {
                _S681 = 0.0f;
                _S682 = 0.0f;
                _S683 = 0.0f;
            }
            else
            {
                var _S724 : f32 = _S674 / _S681;
                var _S725 : f32 = _S682 * - _S724;
                var _S726 : f32 = _S683 * _S724;
                var _S727 : f32 = _S684 * _S725;
                var _S728 : f32 = _S685 * _S725;
                var _S729 : f32 = _S686 * _S728;
                var _S730 : f32 = _S685 * _S728;
                var _S731 : f32 = 0.0f;
                s_bwdProp_exponential_0(_S694, &(_S731), _S726);
                var _S732 : f32 = _S727 + _S729;
                _S681 = - _S731;
                _S682 = _S732;
                _S683 = _S730;
            }
            var _S733 : f32 = _S681 / _S687;
            var _S734 : f32 = _S685 * _S733;
            var _S735 : f32 = _S688 * - _S733 + _S682;
            _S681 = 0.0f;
            _S682 = _S683;
            _S683 = _S734;
            _S684 = _S735;
        }
        else
        {
            _S681 = _S674;
            _S682 = 0.0f;
            _S683 = 0.0f;
            _S684 = 0.0f;
        }
        if(_S680)
        {
            var _S736 : f32 = - (_S681 / _S689);
            var _S737 : f32 = _S691 * _S736;
            var _S738 : f32 = _S690 * _S736 + _S686 * _S737;
            var _S739 : f32 = _S691 * _S737 + _S682;
            var _S740 : f32 = _S738 + _S683;
            _S681 = _S738 + _S684;
            _S682 = _S740;
            _S683 = _S739;
        }
        else
        {
            var _S741 : f32 = _S682;
            _S681 = _S684;
            _S682 = _S683;
            _S683 = _S741;
        }
        var _S742 : f32 = _S677 * _S681;
        var _S743 : vec2<f32> = _S675;
        var _S744 : vec2<f32> = _S675;
        s_bwdProp_dot_0(_S695, &(_S743), &(_S744), _S682);
        var _S745 : vec2<f32> = (_S743 + _S744) / _S696;
        var _S746 : vec2<f32> = _S698 * _S745;
        var _S747 : vec2<f32> = _S697 * (vec2<f32>(0) - _S745) + vec2<f32>(3.14159274101257324f * (_S693 * _S683), _S692 * _S683);
        var _S748 : f32 = _S742 + _S742;
        var _S749 : vec3<f32> = vec3<f32>(_S746[i32(0)], _S746[i32(1)], 0.0f);
        var _S750 : Microfacets_Differential_0 = _S720;
        _S750.alpha_2 = _S747;
        var _S751 : Microfacets_Differential_0 = Microfacets_x24_syn_dadd_0(_S720, _S750);
        _S681 = _S748;
        _S722 = _S749;
        _S723 = _S751;
    }
    else
    {
        _S681 = 0.0f;
        _S722 = _S721;
        _S723 = _S720;
    }
    var _S752 : vec3<f32> = _S722 + vec3<f32>(0.0f, 0.0f, _S681);
    (*_S672) = _S723;
    (*_S673) = _S752;
    return;
}

fn s_bwdProp_mirrored_0( _S753 : s_bwdCallableCtx_mirrored_0,  _S754 : ptr<function, Microfacets_Differential_0>,  _S755 : ptr<function, vec3<f32>>,  _S756 : ptr<function, vec3<f32>>,  _S757 : Mirrored_0)
{
    var _S758 : vec3<f32> = _S753.value0_53.value1_12 + _S753.value0_53.value2_3;
    var _S759 : Tuple_7 = s_apply_normalize_0(_S758);
    var _S760 : s_bwdCallableCtx_normalize_0;
    _S760._S90 = _S758;
    var _S761 : s_bwdCallableCtx_dot_1;
    _S761._S108 = _S753.value0_53.value1_12;
    _S761._S109 = _S759.value0_11;
    var _S762 : Tuple_16 = s_apply_density_0(_S753.value0_53.value0_47, _S759.value0_11);
    var _S763 : s_paramCtx_s_bwdCallableCtx_density_0;
    _S763.value0_66 = _S753.value0_53.value0_47;
    _S763.value1_20 = _S759.value0_11;
    var _S764 : s_bwdCallableCtx_density_0 = s_bwdCallableCtx_density_0( _S763 );
    var _S765 : f32 = 0.25f * _S762.value0_33;
    var _S766 : Tuple_18 = s_apply_visible_over_cos_0(_S753.value0_53.value0_47, _S753.value0_53.value1_12);
    var _S767 : s_paramCtx_s_bwdCallableCtx_visible_over_cos_0;
    _S767.value0_68 = _S753.value0_53.value0_47;
    _S767.value1_21 = _S753.value0_53.value1_12;
    var _S768 : s_bwdCallableCtx_visible_over_cos_0 = s_bwdCallableCtx_visible_over_cos_0( _S767 );
    var _S769 : f32 = _S765 * _S766.value0_35;
    var _S770 : Tuple_18 = s_apply_visible_over_cos_0(_S753.value0_53.value0_47, _S753.value0_53.value2_3);
    var _S771 : s_paramCtx_s_bwdCallableCtx_visible_over_cos_0;
    _S771.value0_68 = _S753.value0_53.value0_47;
    _S771.value1_21 = _S753.value0_53.value2_3;
    var _S772 : s_bwdCallableCtx_visible_over_cos_0 = s_bwdCallableCtx_visible_over_cos_0( _S771 );
    var _S773 : Microfacets_Differential_0 = Microfacets_x24_syn_dzero_0();
    var _S774 : f32 = _S769 * _S770.value0_35 * _S757.scattered_0;
    var _S775 : f32 = _S753.value0_53.value2_3.z * _S757.scattered_0;
    var _S776 : f32 = _S769 * _S775;
    var _S777 : f32 = _S770.value0_35 * _S775;
    var _S778 : vec2<f32> = vec2<f32>(0.0f);
    var _S779 : Microfacets_Differential_0;
    _S779.alpha_2 = _S778;
    var _S780 : vec3<f32> = vec3<f32>(0.0f);
    var _S781 : vec3<f32> = _S780;
    s_bwdProp_visible_over_cos_0(_S772, &(_S779), &(_S781), _S776);
    var _S782 : f32 = _S757.pdf_1 + _S777;
    var _S783 : f32 = _S765 * _S782;
    var _S784 : f32 = _S766.value0_35 * _S782;
    var _S785 : Microfacets_Differential_0;
    _S785.alpha_2 = _S778;
    var _S786 : vec3<f32> = _S780;
    s_bwdProp_visible_over_cos_0(_S768, &(_S785), &(_S786), _S783);
    var _S787 : f32 = 0.25f * _S784;
    var _S788 : Microfacets_Differential_0;
    _S788.alpha_2 = _S778;
    var _S789 : vec3<f32> = _S780;
    s_bwdProp_density_0(_S764, &(_S788), &(_S789), _S787);
    var _S790 : vec3<f32> = _S780;
    var _S791 : vec3<f32> = _S780;
    s_bwdProp_dot_1(_S761, &(_S790), &(_S791), _S757.cosine_0);
    var _S792 : vec3<f32> = _S789 + _S791;
    var _S793 : vec3<f32> = _S780;
    s_bwdProp_normalize_0(_S760, &(_S793), _S792);
    var _S794 : vec3<f32> = _S786 + _S790 + _S793;
    var _S795 : vec3<f32> = _S781 + _S793 + vec3<f32>(0.0f, 0.0f, _S774);
    (*_S754) = Microfacets_x24_syn_dadd_0(Microfacets_x24_syn_dadd_0(Microfacets_x24_syn_dadd_0(_S779, _S785), _S788), _S773);
    (*_S755) = _S794;
    (*_S756) = _S795;
    return;
}

fn s_bwdProp_facets_of_0( _S796 : s_bwdCallableCtx_facets_of_0,  _S797 : ptr<function, Numbers_0>,  _S798 : Microfacets_Differential_0)
{
    var _S799 : vec2<f32> = vec2<f32>(0.00009999999747379f);
    var _S800 : s_bwdCallableCtx_max_0;
    _S800._S40 = _S796.value0_54.value0_46.alpha_0;
    _S800._S41 = _S799;
    var _S801 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S802 : vec2<f32> = vec2<f32>(0.0f);
    var _S803 : vec2<f32> = _S802;
    var _S804 : vec2<f32> = _S802;
    s_bwdProp_max_0(_S800, &(_S803), &(_S804), _S798.alpha_2);
    var _S805 : Numbers_0 = _S801;
    _S805.alpha_0 = _S803;
    (*_S797) = Numbers_x24_syn_dadd_0(_S801, _S805);
    return;
}

fn s_bwdProp_scattering_0( _S806 : s_bwdCallableCtx_scattering_0,  _S807 : ptr<function, Numbers_0>,  _S808 : ptr<function, vec3<f32>>,  _S809 : ptr<function, vec3<f32>>,  _S810 : Scattering_Differential_0)
{
    var _S811 : vec3<f32> = vec3<f32>(0.0f);
    var _S812 : vec2<f32> = vec2<f32>(0.0f);
    var _S813 : Numbers_0 = Numbers_0( _S811, _S811, _S811, _S811, _S812 );
    var _S814 : s_paramCtx_s_bwdCallableCtx_facets_of_0 = s_paramCtx_s_bwdCallableCtx_facets_of_0( _S813 );
    var _S815 : Microfacets_0 = Microfacets_0( u32(0), _S812 );
    var _S816 : s_paramCtx_s_bwdCallableCtx_mirrored_0 = s_paramCtx_s_bwdCallableCtx_mirrored_0( _S815, _S811, _S811 );
    var _S817 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0 = s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0( 0.0f, _S811, _S811 );
    var _S818 : s_paramCtx_s_bwdCallableCtx_coat_eta_0 = s_paramCtx_s_bwdCallableCtx_coat_eta_0( _S813 );
    var _S819 : Lobe_0 = Lobe_0( u32(0), u32(0), u32(0), _S813 );
    var _S820 : s_paramCtx_s_bwdCallableCtx_transmittance_0 = s_paramCtx_s_bwdCallableCtx_transmittance_0( _S819, 0.0f, 0.0f );
    var _S821 : s_minCtx_s_bwdCallableCtx_transmittance_0 = s_minCtx_s_bwdCallableCtx_transmittance_0( 0.0f, 0.0f );
    var _S822 : s_paramCtx_s_bwdCallableCtx_base_0 = s_paramCtx_s_bwdCallableCtx_base_0( _S819, 0.0f, _S811 );
    var _S823 : s_minCtx_s_bwdCallableCtx_base_0 = s_minCtx_s_bwdCallableCtx_base_0( 0.0f, u32(0) );
    var _S824 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0 = s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0( 0.0f, 0.0f );
    var _S825 : f32 = _S806.value0_45.value3_1.z;
    var by_cosine_1 : f32 = _S825 * 0.31830987334251404f;
    var _S826 : vec3<f32> = vec3<f32>(by_cosine_1);
    var _S827 : bool = (_S806.value0_45.value0_44.kind_0) == u32(0);
    var _S828 : vec3<f32>;
    if(_S827)
    {
        _S828 = _S806.value0_45.value1_10.diffuse_reflectance_0;
    }
    else
    {
        _S828 = _S811;
    }
    var _S829 : bool = !_S827;
    var _S830 : vec3<f32>;
    var _S831 : vec3<f32>;
    var _S832 : vec3<f32>;
    var _S833 : vec3<f32>;
    var _S834 : vec3<f32>;
    var _S835 : vec3<f32>;
    var _S836 : vec3<f32>;
    var by_facets_1 : Mirrored_0;
    var _S837 : s_bwdCallableCtx_mirrored_0;
    var _S838 : s_bwdCallableCtx_facets_of_0;
    var _runFlag_5 : bool;
    var _S839 : bool;
    var _S840 : bool;
    var _S841 : bool;
    var _S842 : s_bwdCallableCtx_fresnel_conductor_0;
    var _S843 : f32;
    var _S844 : f32;
    var _S845 : f32;
    var _S846 : f32;
    var _S847 : f32;
    var _S848 : f32;
    var _S849 : f32;
    var _S850 : f32;
    var _S851 : f32;
    var _S852 : s_bwdCallableCtx_fresnel_dielectric_0;
    var _S853 : s_bwdCallableCtx_base_0;
    var _S854 : s_bwdCallableCtx_transmittance_0;
    var _S855 : s_bwdCallableCtx_transmittance_0;
    var _S856 : s_bwdCallableCtx_coat_eta_0;
    if(_S829)
    {
        var _S857 : Tuple_13 = s_apply_Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
        var _S858 : bool = is_rough_0(_S806.value0_45.value0_44);
        if(_S858)
        {
            var _S859 : Tuple_14 = s_apply_facets_of_0(_S806.value0_45.value0_44, _S806.value0_45.value1_10);
            var _S860 : s_paramCtx_s_bwdCallableCtx_facets_of_0;
            _S860.value0_46 = _S806.value0_45.value1_10;
            var _S861 : Tuple_15 = s_apply_mirrored_0(_S859.value0_31, _S806.value0_45.value2_2, _S806.value0_45.value3_1);
            var _S862 : s_paramCtx_s_bwdCallableCtx_mirrored_0;
            _S862.value0_47 = _S859.value0_31;
            _S862.value1_12 = _S806.value0_45.value2_2;
            _S862.value2_3 = _S806.value0_45.value3_1;
            by_facets_1 = _S861.value0_32;
            _S837.value0_53 = _S862;
            _S838.value0_54 = _S860;
        }
        else
        {
            by_facets_1 = _S857.value0_30;
            _S837.value0_53 = _S816;
            _S838.value0_54 = _S814;
        }
        var _S863 : bool = (_S806.value0_45.value0_44.kind_0) == u32(2);
        if(_S863)
        {
            var _S864 : Tuple_19 = s_apply_fresnel_conductor_0(by_facets_1.cosine_0, _S806.value0_45.value1_10.eta_0, _S806.value0_45.value1_10.k_0);
            var _S865 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0;
            _S865.value0_48 = by_facets_1.cosine_0;
            _S865.value1_13 = _S806.value0_45.value1_10.eta_0;
            _S865.value2_4 = _S806.value0_45.value1_10.k_0;
            var _S866 : vec3<f32> = vec3<f32>(by_facets_1.scattered_0);
            var _S867 : vec3<f32> = _S864.value0_36 * _S866;
            _runFlag_5 = false;
            _S830 = _S806.value0_45.value1_10.specular_reflectance_0;
            _S831 = _S867;
            _S832 = _S864.value0_36;
            _S833 = _S866;
            _S842.value0_55 = _S865;
        }
        else
        {
            _runFlag_5 = _S829;
            _S830 = _S811;
            _S831 = _S811;
            _S832 = _S811;
            _S833 = _S811;
            _S842.value0_55 = _S817;
        }
        if(_runFlag_5)
        {
            var _S868 : Tuple_21 = s_apply_coat_eta_0(_S806.value0_45.value1_10);
            var _S869 : s_paramCtx_s_bwdCallableCtx_coat_eta_0;
            _S869.value0_49 = _S806.value0_45.value1_10;
            var _S870 : s_paramCtx_s_bwdCallableCtx_coat_eta_0 = _S869;
            var _S871 : f32 = _S806.value0_45.value2_2.z;
            var _S872 : s_paramCtx_s_bwdCallableCtx_transmittance_0;
            _S872.value0_50 = _S806.value0_45.value0_44;
            _S872.value1_14 = _S868.value0_38;
            _S872.value2_5 = _S871;
            var _S873 : s_paramCtx_s_bwdCallableCtx_transmittance_0 = _S872;
            var _S874 : s_paramCtx_s_bwdCallableCtx_transmittance_0;
            _S874.value0_50 = _S806.value0_45.value0_44;
            _S874.value1_14 = _S868.value0_38;
            _S874.value2_5 = _S825;
            var _S875 : s_paramCtx_s_bwdCallableCtx_transmittance_0 = _S874;
            var _S876 : s_paramCtx_s_bwdCallableCtx_base_0;
            _S876.value0_51 = _S806.value0_45.value0_44;
            _S876.value1_15 = _S868.value0_38;
            _S876.value2_6 = _S806.value0_45.value1_10.diffuse_reflectance_0;
            var _S877 : s_paramCtx_s_bwdCallableCtx_base_0 = _S876;
            var _S878 : f32 = _S806.value1_11.value0_28 * _S806.value1_11.value2_1;
            var _S879 : f32 = _S878 * by_cosine_1;
            var _S880 : f32 = _S868.value0_38 * _S868.value0_38;
            var _S881 : vec3<f32> = vec3<f32>((_S879 / _S880));
            var _S882 : f32 = _S880 * _S880;
            var probability_1 : f32 = base_probability_0(_S806.value0_45.value1_10, _S806.value1_11.value0_28);
            var _S883 : bool = (_S806.value0_45.value0_44.kind_0) == u32(4);
            if(_S883)
            {
                var _S884 : Tuple_24 = s_apply_fresnel_dielectric_0(by_facets_1.cosine_0, _S868.value0_38);
                var _S885 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0;
                _S885.value0_52 = by_facets_1.cosine_0;
                _S885.value1_16 = _S868.value0_38;
                var _S886 : vec3<f32> = vec3<f32>((_S884.value0_41 * by_facets_1.scattered_0));
                _S843 = 1.0f - probability_1;
                _S834 = _S806.value0_45.value1_10.specular_reflectance_0;
                _S835 = _S886;
                _S844 = _S884.value0_41;
                _S845 = by_facets_1.scattered_0;
                _S852.value0_56 = _S885;
            }
            else
            {
                _S843 = 0.0f;
                _S834 = _S811;
                _S835 = _S811;
                _S844 = 0.0f;
                _S845 = 0.0f;
                _S852.value0_56 = _S824;
            }
            _S839 = _S883;
            _S846 = probability_1;
            _S836 = _S881;
            _S847 = _S882;
            _S848 = _S879;
            _S849 = _S880;
            _S850 = _S868.value0_38;
            _S851 = _S878;
            _S853.value0_57 = _S877;
            _S853.value1_17 = _S806.value1_11.value5_0;
            _S854.value0_58 = _S875;
            _S854.value1_18 = _S806.value1_11.value3_0;
            _S855.value0_58 = _S873;
            _S855.value1_18 = _S806.value1_11.value1_6;
            _S856.value0_59 = _S870;
        }
        else
        {
            _S839 = false;
            _S843 = 0.0f;
            _S834 = _S811;
            _S835 = _S811;
            _S844 = 0.0f;
            _S845 = 0.0f;
            _S852.value0_56 = _S824;
            _S846 = 0.0f;
            _S836 = _S811;
            _S847 = 0.0f;
            _S848 = 0.0f;
            _S849 = 0.0f;
            _S850 = 0.0f;
            _S851 = 0.0f;
            _S853.value0_57 = _S822;
            _S853.value1_17 = _S823;
            _S854.value0_58 = _S820;
            _S854.value1_18 = _S821;
            _S855.value0_58 = _S820;
            _S855.value1_18 = _S821;
            _S856.value0_59 = _S818;
        }
        var _S887 : vec3<f32> = _S830;
        var _S888 : vec3<f32> = _S831;
        var _S889 : vec3<f32> = _S832;
        var _S890 : vec3<f32> = _S833;
        _S830 = _S834;
        _S831 = _S835;
        _S832 = _S836;
        _S840 = _S863;
        _S833 = _S887;
        _S834 = _S888;
        _S835 = _S889;
        _S836 = _S890;
        _S841 = _S858;
    }
    else
    {
        _runFlag_5 = false;
        _S839 = false;
        _S843 = 0.0f;
        _S830 = _S811;
        _S831 = _S811;
        _S844 = 0.0f;
        _S845 = 0.0f;
        _S852.value0_56 = _S824;
        _S846 = 0.0f;
        _S832 = _S811;
        _S847 = 0.0f;
        _S848 = 0.0f;
        _S849 = 0.0f;
        _S850 = 0.0f;
        _S851 = 0.0f;
        _S853.value0_57 = _S822;
        _S853.value1_17 = _S823;
        _S854.value0_58 = _S820;
        _S854.value1_18 = _S821;
        _S855.value0_58 = _S820;
        _S855.value1_18 = _S821;
        _S856.value0_59 = _S818;
        _S840 = false;
        _S833 = _S811;
        _S834 = _S811;
        _S835 = _S811;
        _S836 = _S811;
        _S842.value0_55 = _S817;
        _S841 = false;
        _S837.value0_53 = _S816;
        _S838.value0_54 = _S814;
    }
    var _S891 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S892 : Mirrored_0 = Mirrored_x24_syn_dzero_0();
    var _S893 : Scattering_Differential_0 = Scattering_x24_syn_dzero_0();
    var _S894 : Scattering_Differential_0 = Scattering_x24_syn_dadd_0(_S810, _S893);
    var _S895 : Scattering_Differential_0;
    var _S896 : Numbers_0;
    if(_S829)
    {
        if(_runFlag_5)
        {
            if(_S839)
            {
                var _S897 : f32 = _S843 * 0.0f;
                var _S898 : vec3<f32> = _S830 * _S894.value_0;
                var _S899 : vec3<f32> = _S831 * _S894.value_0;
                var _S900 : f32 = _S898[i32(0)] + _S898[i32(1)] + _S898[i32(2)];
                var _S901 : f32 = _S844 * _S900;
                var _S902 : f32 = _S845 * _S900;
                var _S903 : f32 = 0.0f;
                var _S904 : f32 = 0.0f;
                s_bwdProp_fresnel_dielectric_0(_S852, &(_S903), &(_S904), _S902);
                var _S905 : Mirrored_0 = _S892;
                _S905.pdf_1 = _S897;
                _S905.scattered_0 = _S901;
                _S905.cosine_0 = _S903;
                var _S906 : Mirrored_0 = Mirrored_x24_syn_dadd_0(_S892, _S905);
                var _S907 : Numbers_0 = _S891;
                _S907.specular_reflectance_0 = _S899;
                var _S908 : Numbers_0 = Numbers_x24_syn_dadd_0(_S891, _S907);
                _S895 = _S893;
                _S830 = _S894.value_0;
                _S843 = _S904;
                _S896 = _S908;
                by_facets_1 = _S906;
            }
            else
            {
                _S895 = Scattering_x24_syn_dadd_0(_S894, _S893);
                _S830 = _S811;
                _S843 = 0.0f;
                _S896 = _S891;
                by_facets_1 = _S892;
            }
            var _S909 : f32 = _S846 * 0.0f;
            var _S910 : vec3<f32> = _S895.value_0 + _S830;
            var _S911 : vec3<f32> = _S806.value1_11.value4_0 * _S910;
            var _S912 : vec3<f32> = _S832 * _S910;
            var _S913 : f32 = (_S911[i32(0)] + _S911[i32(1)] + _S911[i32(2)]) / _S847;
            var _S914 : f32 = _S849 * _S913;
            var _S915 : f32 = _S850 * (_S848 * - _S913);
            var _S916 : f32 = _S851 * _S914;
            var _S917 : f32 = by_cosine_1 * _S914;
            var _S918 : f32 = _S806.value1_11.value0_28 * _S917;
            var _S919 : f32 = _S806.value1_11.value2_1 * _S917;
            var _S920 : f32 = 0.0f;
            var _S921 : vec3<f32> = _S811;
            s_bwdProp_base_0(_S853, &(_S920), &(_S921), _S912);
            var _S922 : f32 = 0.0f;
            var _S923 : f32 = 0.0f;
            s_bwdProp_transmittance_0(_S854, &(_S922), &(_S923), _S918);
            var _S924 : f32 = 0.0f;
            var _S925 : f32 = 0.0f;
            s_bwdProp_transmittance_0(_S855, &(_S924), &(_S925), _S919);
            var _S926 : f32 = _S915 + _S915 + _S920 + _S922 + _S924 + _S843;
            var _S927 : Numbers_0;
            _S927.diffuse_reflectance_0 = _S811;
            _S927.specular_reflectance_0 = _S811;
            _S927.eta_0 = _S811;
            _S927.k_0 = _S811;
            _S927.alpha_0 = _S812;
            s_bwdProp_coat_eta_0(_S856, &(_S927), _S926);
            var _S928 : f32 = _S909 + _S916;
            var _S929 : vec3<f32> = vec3<f32>(0.0f, 0.0f, _S925);
            var _S930 : Numbers_0 = Numbers_x24_syn_dadd_0(_S927, _S896);
            var _S931 : Numbers_0 = _S891;
            _S931.diffuse_reflectance_0 = _S921;
            var _S932 : Numbers_0 = Numbers_x24_syn_dadd_0(_S930, _S931);
            _S895 = _S893;
            _S896 = _S932;
            _S830 = _S929;
            _S843 = _S928;
            _S844 = _S923;
        }
        else
        {
            _S895 = Scattering_x24_syn_dadd_0(_S894, _S893);
            by_facets_1 = _S892;
            _S896 = _S891;
            _S830 = _S811;
            _S843 = 0.0f;
            _S844 = 0.0f;
        }
        if(_S840)
        {
            var _S933 : vec3<f32> = _S833 * _S895.value_0;
            var _S934 : vec3<f32> = _S834 * _S895.value_0;
            var _S935 : vec3<f32> = _S835 * _S933;
            var _S936 : vec3<f32> = _S836 * _S933;
            var _S937 : f32 = _S935[i32(0)] + _S935[i32(1)] + _S935[i32(2)];
            var _S938 : f32 = 0.0f;
            var _S939 : vec3<f32> = _S811;
            var _S940 : vec3<f32> = _S811;
            s_bwdProp_fresnel_conductor_0(_S842, &(_S938), &(_S939), &(_S940), _S936);
            var _S941 : Mirrored_0 = _S892;
            _S941.pdf_1 = 0.0f;
            _S941.scattered_0 = _S937;
            _S941.cosine_0 = _S938;
            var _S942 : Mirrored_0 = Mirrored_x24_syn_dadd_0(by_facets_1, _S941);
            var _S943 : Numbers_0 = _S891;
            _S943.specular_reflectance_0 = _S934;
            _S943.k_0 = _S940;
            _S943.eta_0 = _S939;
            var _S944 : Numbers_0 = Numbers_x24_syn_dadd_0(_S896, _S943);
            by_facets_1 = _S942;
            _S896 = _S944;
            _S895 = _S893;
        }
        else
        {
            _S895 = Scattering_x24_syn_dadd_0(_S895, _S893);
        }
        if(_S841)
        {
            var _S945 : Microfacets_Differential_0;
            _S945.alpha_2 = _S812;
            var _S946 : vec3<f32> = _S811;
            var _S947 : vec3<f32> = _S811;
            s_bwdProp_mirrored_0(_S837, &(_S945), &(_S946), &(_S947), by_facets_1);
            var _S948 : Numbers_0;
            _S948.diffuse_reflectance_0 = _S811;
            _S948.specular_reflectance_0 = _S811;
            _S948.eta_0 = _S811;
            _S948.k_0 = _S811;
            _S948.alpha_0 = _S812;
            s_bwdProp_facets_of_0(_S838, &(_S948), _S945);
            var _S949 : vec3<f32> = _S946 + _S830;
            _S896 = Numbers_x24_syn_dadd_0(_S948, _S896);
            _S830 = _S947;
            _S831 = _S949;
        }
        else
        {
            var _S950 : vec3<f32> = _S830;
            _S830 = _S811;
            _S831 = _S950;
        }
    }
    else
    {
        _S895 = Scattering_x24_syn_dadd_0(_S894, _S893);
        _S896 = _S891;
        _S843 = 0.0f;
        _S844 = 0.0f;
        _S830 = _S811;
        _S831 = _S811;
    }
    if(_S827)
    {
        var _S951 : vec3<f32> = _S828 * _S895.value_0;
        var _S952 : vec3<f32> = _S826 * _S895.value_0;
        var _S953 : Numbers_0 = _S891;
        _S953.diffuse_reflectance_0 = _S952;
        var _S954 : Numbers_0 = Numbers_x24_syn_dadd_0(_S896, _S953);
        _S828 = _S951;
        _S896 = _S954;
    }
    else
    {
        _S828 = _S811;
    }
    var _S955 : vec3<f32> = _S830 + vec3<f32>(0.0f, 0.0f, 0.31830987334251404f * (_S828[i32(0)] + _S828[i32(1)] + _S828[i32(2)] + _S843) + _S844);
    (*_S807) = _S896;
    (*_S808) = _S831;
    (*_S809) = _S955;
    return;
}

fn _S956( _S957 : Lobe_0,  _S958 : ptr<function, DiffPair_Numbers_0>,  _S959 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S960 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S961 : Scattering_Differential_0)
{
    var _S962 : Tuple_12 = s_apply_scattering_0(_S957, (*_S958).primal_0, (*_S959).primal_0, (*_S960).primal_0);
    var _S963 : s_paramCtx_s_bwdCallableCtx_scattering_0;
    _S963.value0_44 = _S957;
    _S963.value1_10 = (*_S958).primal_0;
    _S963.value2_2 = (*_S959).primal_0;
    _S963.value3_1 = (*_S960).primal_0;
    var _S964 : s_bwdCallableCtx_scattering_0 = s_bwdCallableCtx_scattering_0( _S963, _S962.value1_7 );
    var _S965 : Numbers_0 = (*_S958).differential_0;
    var _S966 : vec3<f32> = (*_S959).differential_0;
    var _S967 : vec3<f32> = (*_S960).differential_0;
    s_bwdProp_scattering_0(_S964, &(_S965), &(_S966), &(_S967), _S961);
    (*_S958).differential_0 = _S965;
    (*_S959).differential_0 = _S966;
    (*_S960).differential_0 = _S967;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_specular_fraction_0
{
     value0_72 : Lobe_0,
     value1_22 : Numbers_0,
     value2_8 : vec3<f32>,
};

struct s_bwdCallableCtx_specular_fraction_0
{
     value0_73 : s_paramCtx_s_bwdCallableCtx_specular_fraction_0,
};

fn s_bwdProp_specular_fraction_0( _S968 : s_bwdCallableCtx_specular_fraction_0,  _S969 : ptr<function, Numbers_0>,  _S970 : ptr<function, vec3<f32>>,  _S971 : vec3<f32>)
{
    var _S972 : vec3<f32> = vec3<f32>(0.0f);
    var _S973 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0 = s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0( 0.0f, _S972, _S972 );
    var _S974 : vec2<f32> = vec2<f32>(0.0f);
    var _S975 : Numbers_0 = Numbers_0( _S972, _S972, _S972, _S972, _S974 );
    var _S976 : s_paramCtx_s_bwdCallableCtx_coat_eta_0 = s_paramCtx_s_bwdCallableCtx_coat_eta_0( _S975 );
    var _S977 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0 = s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0( 0.0f, 0.0f );
    var _S978 : bool = (_S968.value0_73.value0_72.kind_0) == u32(1);
    var _S979 : vec3<f32>;
    var _S980 : vec3<f32>;
    var _S981 : s_bwdCallableCtx_fresnel_conductor_0;
    if(_S978)
    {
        var _S982 : f32 = _S968.value0_73.value2_8.z;
        var _S983 : Tuple_19 = s_apply_fresnel_conductor_0(_S982, _S968.value0_73.value1_22.eta_0, _S968.value0_73.value1_22.k_0);
        var _S984 : s_paramCtx_s_bwdCallableCtx_fresnel_conductor_0;
        _S984.value0_48 = _S982;
        _S984.value1_13 = _S968.value0_73.value1_22.eta_0;
        _S984.value2_4 = _S968.value0_73.value1_22.k_0;
        _S979 = _S968.value0_73.value1_22.specular_reflectance_0;
        _S980 = _S983.value0_36;
        _S981.value0_55 = _S984;
    }
    else
    {
        _S979 = _S972;
        _S980 = _S972;
        _S981.value0_55 = _S973;
    }
    var _S985 : bool = !_S978;
    var _S986 : vec3<f32>;
    var _S987 : vec3<f32>;
    var _S988 : s_bwdCallableCtx_fresnel_dielectric_0;
    var _S989 : s_bwdCallableCtx_coat_eta_0;
    if(_S985)
    {
        var _S990 : f32 = _S968.value0_73.value2_8.z;
        var _S991 : Tuple_21 = s_apply_coat_eta_0(_S968.value0_73.value1_22);
        var _S992 : s_paramCtx_s_bwdCallableCtx_coat_eta_0;
        _S992.value0_49 = _S968.value0_73.value1_22;
        var _S993 : vec3<f32> = vec3<f32>(s_apply_fresnel_dielectric_0(_S990, _S991.value0_38).value0_41);
        var _S994 : s_paramCtx_s_bwdCallableCtx_fresnel_dielectric_0;
        _S994.value0_52 = _S990;
        _S994.value1_16 = _S991.value0_38;
        _S986 = _S968.value0_73.value1_22.specular_reflectance_0;
        _S987 = _S993;
        _S988.value0_56 = _S994;
        _S989.value0_59 = _S992;
    }
    else
    {
        _S986 = _S972;
        _S987 = _S972;
        _S988.value0_56 = _S977;
        _S989.value0_59 = _S976;
    }
    var _S995 : Numbers_0 = Numbers_x24_syn_dzero_0();
    var _S996 : Numbers_0;
    if(_S985)
    {
        var _S997 : vec3<f32> = _S986 * _S971;
        var _S998 : vec3<f32> = _S987 * _S971;
        var _S999 : f32 = _S997[i32(0)] + _S997[i32(1)] + _S997[i32(2)];
        var _S1000 : f32 = 0.0f;
        var _S1001 : f32 = 0.0f;
        s_bwdProp_fresnel_dielectric_0(_S988, &(_S1000), &(_S1001), _S999);
        var _S1002 : Numbers_0;
        _S1002.diffuse_reflectance_0 = _S972;
        _S1002.specular_reflectance_0 = _S972;
        _S1002.eta_0 = _S972;
        _S1002.k_0 = _S972;
        _S1002.alpha_0 = _S974;
        s_bwdProp_coat_eta_0(_S989, &(_S1002), _S1001);
        var _S1003 : vec3<f32> = vec3<f32>(0.0f, 0.0f, _S1000);
        var _S1004 : Numbers_0 = Numbers_x24_syn_dadd_0(_S1002, _S995);
        var _S1005 : Numbers_0 = _S995;
        _S1005.specular_reflectance_0 = _S998;
        var _S1006 : Numbers_0 = Numbers_x24_syn_dadd_0(_S1004, _S1005);
        _S986 = _S972;
        _S987 = _S1003;
        _S996 = _S1006;
    }
    else
    {
        _S986 = _S971;
        _S987 = _S972;
        _S996 = _S995;
    }
    if(_S978)
    {
        var _S1007 : vec3<f32> = _S979 * _S986;
        var _S1008 : vec3<f32> = _S980 * _S986;
        var _S1009 : f32 = 0.0f;
        var _S1010 : vec3<f32> = _S972;
        var _S1011 : vec3<f32> = _S972;
        s_bwdProp_fresnel_conductor_0(_S981, &(_S1009), &(_S1010), &(_S1011), _S1007);
        var _S1012 : vec3<f32> = _S987 + vec3<f32>(0.0f, 0.0f, _S1009);
        var _S1013 : Numbers_0 = _S995;
        _S1013.k_0 = _S1011;
        _S1013.eta_0 = _S1010;
        _S1013.specular_reflectance_0 = _S1008;
        _S996 = Numbers_x24_syn_dadd_0(_S996, _S1013);
        _S979 = _S1012;
    }
    else
    {
        _S979 = _S987;
    }
    (*_S969) = _S996;
    (*_S970) = _S979;
    return;
}

fn _S1014( _S1015 : Lobe_0,  _S1016 : ptr<function, DiffPair_Numbers_0>,  _S1017 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S1018 : vec3<f32>)
{
    var _S1019 : s_paramCtx_s_bwdCallableCtx_specular_fraction_0;
    _S1019.value0_72 = _S1015;
    _S1019.value1_22 = (*_S1016).primal_0;
    _S1019.value2_8 = (*_S1017).primal_0;
    var _S1020 : s_bwdCallableCtx_specular_fraction_0 = s_bwdCallableCtx_specular_fraction_0( _S1019 );
    var _S1021 : Numbers_0 = (*_S1016).differential_0;
    var _S1022 : vec3<f32> = (*_S1017).differential_0;
    s_bwdProp_specular_fraction_0(_S1020, &(_S1021), &(_S1022), _S1018);
    (*_S1016).differential_0 = _S1021;
    (*_S1017).differential_0 = _S1022;
    return;
}

struct s_minCtx_s_bwdCallableCtx_map_place_0
{
     value0_74 : vec3<f32>,
     value1_23 : vec3<f32>,
     value2_9 : vec3<f32>,
     value3_2 : u32,
     value4_1 : u32,
};

struct Tuple_27
{
     value0_75 : vec2<f32>,
     value1_24 : s_minCtx_s_bwdCallableCtx_map_place_0,
};

fn vector_at_0( at_3 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_3), number_0(at_3 + u32(1)), number_0(at_3 + u32(2)));
}

struct Tuple_28
{
     value0_76 : f32,
};

fn s_apply_angle_of_0( _S1023 : f32,  _S1024 : f32) -> Tuple_28
{
    var _S1025 : Tuple_10 = s_apply_abs_0(_S1023);
    var _S1026 : Tuple_10 = s_apply_abs_0(_S1024);
    var _S1027 : Tuple_5 = s_apply_min_0(_S1025.value0_16, _S1026.value0_16);
    var _S1028 : Tuple_9 = s_apply_max_1(_S1025.value0_16, _S1026.value0_16);
    var is_steep_0 : bool = (_S1027.value0_7) > (0.41421356797218323f * _S1028.value0_15);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S1027.value0_7 - _S1028.value0_15;
    }
    else
    {
        above_0 = _S1027.value0_7;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S1027.value0_7 + _S1028.value0_15;
    }
    else
    {
        below_0 = _S1028.value0_15;
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
    if((_S1026.value0_16) > (_S1025.value0_16))
    {
        angle_1 = 1.57079637050628662f - angle_1;
    }
    if(_S1023 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(_S1024 < 0.0f)
    {
        above_0 = - angle_1;
    }
    else
    {
        above_0 = angle_1;
    }
    var _S1029 : Tuple_28;
    _S1029.value0_76 = above_0;
    return _S1029;
}

fn s_apply_map_place_0( map_0 : u32,  _S1030 : vec3<f32>) -> Tuple_27
{
    var _S1031 : vec3<f32> = vec3<f32>(0.0f);
    var _S1032 : s_minCtx_s_bwdCallableCtx_map_place_0;
    _S1032.value0_74 = _S1031;
    _S1032.value1_23 = _S1031;
    _S1032.value2_9 = _S1031;
    _S1032.value3_2 = u32(0);
    _S1032.value4_1 = u32(0);
    var _S1033 : u32 = map_0 + u32(2);
    var _S1034 : vec3<f32> = vector_at_0(_S1033);
    _S1032.value0_74 = _S1034;
    var _S1035 : vec3<f32> = _S1034 * vec3<f32>(_S1030.x);
    var _S1036 : vec3<f32> = vector_at_0(_S1033 + u32(3));
    _S1032.value1_23 = _S1036;
    var _S1037 : vec3<f32> = _S1035 + _S1036 * vec3<f32>(_S1030.y);
    var _S1038 : vec3<f32> = vector_at_0(_S1033 + u32(6));
    _S1032.value2_9 = _S1038;
    var d_0 : vec3<f32> = _S1037 + _S1038 * vec3<f32>(_S1030.z);
    var _S1039 : Tuple_28 = s_apply_angle_of_0(- d_0.z, d_0.x);
    var _S1040 : Tuple_28 = s_apply_angle_of_0(d_0.y, s_apply_length_1(d_0.xz).value0_8);
    var _S1041 : u32 = word_0(map_0);
    _S1032.value3_2 = _S1041;
    var width_0 : f32 = f32(_S1041);
    var _S1042 : u32 = word_0(map_0 + u32(1));
    _S1032.value4_1 = _S1042;
    var _S1043 : Tuple_27;
    _S1043.value0_75 = vec2<f32>(_S1039.value0_76 * 0.15915493667125702f * width_0 - 0.5f, _S1040.value0_76 * 0.31830987334251404f * (f32(_S1042) - 1.0f));
    _S1043.value1_24 = _S1032;
    return _S1043;
}

struct s_paramCtx_s_bwdCallableCtx_map_place_0
{
     value0_77 : vec3<f32>,
};

struct s_bwdCallableCtx_map_place_0
{
     value0_78 : s_paramCtx_s_bwdCallableCtx_map_place_0,
     value1_25 : s_minCtx_s_bwdCallableCtx_map_place_0,
};

struct s_paramCtx_s_bwdCallableCtx_angle_of_0
{
     value0_79 : f32,
     value1_26 : f32,
};

struct s_bwdCallableCtx_angle_of_0
{
     value0_80 : s_paramCtx_s_bwdCallableCtx_angle_of_0,
};

fn s_bwdProp_angle_of_0( _S1044 : s_bwdCallableCtx_angle_of_0,  _S1045 : ptr<function, f32>,  _S1046 : ptr<function, f32>,  _S1047 : f32)
{
    var _S1048 : Tuple_10 = s_apply_abs_0(_S1044.value0_80.value0_79);
    var _S1049 : s_bwdCallableCtx_abs_0;
    _S1049._S118 = _S1044.value0_80.value0_79;
    var _S1050 : s_bwdCallableCtx_abs_0 = _S1049;
    var _S1051 : Tuple_10 = s_apply_abs_0(_S1044.value0_80.value1_26);
    var _S1052 : s_bwdCallableCtx_abs_0;
    _S1052._S118 = _S1044.value0_80.value1_26;
    var _S1053 : s_bwdCallableCtx_abs_0 = _S1052;
    var _S1054 : Tuple_5 = s_apply_min_0(_S1048.value0_16, _S1051.value0_16);
    var _S1055 : s_bwdCallableCtx_min_0;
    _S1055._S49 = _S1048.value0_16;
    _S1055._S50 = _S1051.value0_16;
    var _S1056 : s_bwdCallableCtx_min_0 = _S1055;
    var _S1057 : Tuple_9 = s_apply_max_1(_S1048.value0_16, _S1051.value0_16);
    var _S1058 : s_bwdCallableCtx_max_1;
    _S1058._S113 = _S1048.value0_16;
    _S1058._S114 = _S1051.value0_16;
    var _S1059 : s_bwdCallableCtx_max_1 = _S1058;
    var is_steep_1 : bool = (_S1054.value0_7) > (0.41421356797218323f * _S1057.value0_15);
    var above_1 : f32;
    if(is_steep_1)
    {
        above_1 = _S1054.value0_7 - _S1057.value0_15;
    }
    else
    {
        above_1 = _S1054.value0_7;
    }
    var below_1 : f32;
    if(is_steep_1)
    {
        below_1 = _S1054.value0_7 + _S1057.value0_15;
    }
    else
    {
        below_1 = _S1057.value0_15;
    }
    var _S1060 : bool = below_1 > 0.0f;
    if(_S1060)
    {
    }
    else
    {
        below_1 = 1.0f;
    }
    var t_2 : f32 = above_1 / below_1;
    var _S1061 : f32 = below_1 * below_1;
    var z_1 : f32 = t_2 * t_2;
    var _S1062 : f32 = 0.08053744584321976f * z_1 - 0.13877685368061066f;
    var _S1063 : f32 = _S1062 * z_1 + 0.19977711141109467f;
    var tail_2 : f32 = _S1063 * z_1 - 0.33332949876785278f;
    var _S1064 : f32 = tail_2 * z_1;
    var _S1065 : bool = (_S1051.value0_16) > (_S1048.value0_16);
    var _S1066 : bool = (_S1044.value0_80.value0_79) < 0.0f;
    var _S1067 : f32;
    if((_S1044.value0_80.value1_26) < 0.0f)
    {
        _S1067 = - _S1047;
    }
    else
    {
        _S1067 = _S1047;
    }
    if(_S1066)
    {
        _S1067 = - _S1067;
    }
    if(_S1065)
    {
        _S1067 = - _S1067;
    }
    var _S1068 : f32 = t_2 * _S1067;
    var s_diff_tail_T_2 : f32 = z_1 * _S1068;
    var _S1069 : f32 = z_1 * s_diff_tail_T_2;
    var _S1070 : f32 = t_2 * (tail_2 * _S1068 + _S1063 * s_diff_tail_T_2 + _S1062 * _S1069 + 0.08053744584321976f * (z_1 * _S1069));
    var _S1071 : f32 = (_S1067 + _S1064 * _S1067 + _S1070 + _S1070) / _S1061;
    var _S1072 : f32 = above_1 * - _S1071;
    var _S1073 : f32 = below_1 * _S1071;
    if(_S1060)
    {
        above_1 = _S1072;
    }
    else
    {
        above_1 = 0.0f;
    }
    if(is_steep_1)
    {
        below_1 = above_1;
    }
    else
    {
        below_1 = 0.0f;
    }
    if(is_steep_1)
    {
        var _S1074 : f32 = _S1073 + below_1;
        above_1 = - _S1073 + above_1;
        below_1 = _S1074;
    }
    else
    {
        below_1 = _S1073 + below_1;
    }
    var _S1075 : f32 = 0.0f;
    var _S1076 : f32 = 0.0f;
    s_bwdProp_max_1(_S1059, &(_S1075), &(_S1076), above_1);
    var _S1077 : f32 = 0.0f;
    var _S1078 : f32 = 0.0f;
    s_bwdProp_min_0(_S1056, &(_S1077), &(_S1078), below_1);
    var _S1079 : f32 = _S1076 + _S1078;
    var _S1080 : f32 = 0.0f;
    s_bwdProp_abs_0(_S1053, &(_S1080), _S1079);
    var _S1081 : f32 = _S1075 + _S1077;
    var _S1082 : f32 = 0.0f;
    s_bwdProp_abs_0(_S1050, &(_S1082), _S1081);
    (*_S1045) = _S1082;
    (*_S1046) = _S1080;
    return;
}

fn s_bwdProp_map_place_0( _S1083 : s_bwdCallableCtx_map_place_0,  _S1084 : ptr<function, vec3<f32>>,  _S1085 : vec2<f32>)
{
    var d_1 : vec3<f32> = _S1083.value1_25.value0_74 * vec3<f32>(_S1083.value0_78.value0_77.x) + _S1083.value1_25.value1_23 * vec3<f32>(_S1083.value0_78.value0_77.y) + _S1083.value1_25.value2_9 * vec3<f32>(_S1083.value0_78.value0_77.z);
    var _S1086 : f32 = d_1.x;
    var _S1087 : s_paramCtx_s_bwdCallableCtx_angle_of_0;
    _S1087.value0_79 = - d_1.z;
    _S1087.value1_26 = _S1086;
    var _S1088 : s_bwdCallableCtx_angle_of_0 = s_bwdCallableCtx_angle_of_0( _S1087 );
    var _S1089 : f32 = d_1.y;
    var _S1090 : vec2<f32> = d_1.xz;
    var _S1091 : Tuple_6 = s_apply_length_1(_S1090);
    var _S1092 : s_bwdCallableCtx_length_1;
    _S1092._S57 = _S1090;
    var _S1093 : s_paramCtx_s_bwdCallableCtx_angle_of_0;
    _S1093.value0_79 = _S1089;
    _S1093.value1_26 = _S1091.value0_8;
    var _S1094 : s_bwdCallableCtx_angle_of_0 = s_bwdCallableCtx_angle_of_0( _S1093 );
    var _S1095 : f32 = 0.31830987334251404f * ((f32(_S1083.value1_25.value4_1) - 1.0f) * _S1085[i32(1)]);
    var _S1096 : f32 = 0.15915493667125702f * (f32(_S1083.value1_25.value3_2) * _S1085[i32(0)]);
    var _S1097 : f32 = 0.0f;
    var _S1098 : f32 = 0.0f;
    s_bwdProp_angle_of_0(_S1094, &(_S1097), &(_S1098), _S1095);
    var _S1099 : vec2<f32> = vec2<f32>(0.0f);
    s_bwdProp_length_1(_S1092, &(_S1099), _S1098);
    var _S1100 : f32 = 0.0f;
    var _S1101 : f32 = 0.0f;
    s_bwdProp_angle_of_0(_S1088, &(_S1100), &(_S1101), _S1096);
    var s_diff_d_T_0 : vec3<f32> = vec3<f32>(_S1099[i32(0)] + _S1101, _S1097, _S1099[i32(1)] + - _S1100);
    var _S1102 : vec3<f32> = _S1083.value1_25.value2_9 * s_diff_d_T_0;
    var _S1103 : vec3<f32> = _S1083.value1_25.value1_23 * s_diff_d_T_0;
    var _S1104 : vec3<f32> = _S1083.value1_25.value0_74 * s_diff_d_T_0;
    (*_S1084) = vec3<f32>(_S1104[i32(0)] + _S1104[i32(1)] + _S1104[i32(2)], _S1103[i32(0)] + _S1103[i32(1)] + _S1103[i32(2)], _S1102[i32(0)] + _S1102[i32(1)] + _S1102[i32(2)]);
    return;
}

fn _S1105( _S1106 : u32,  _S1107 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S1108 : vec2<f32>)
{
    var _S1109 : Tuple_27 = s_apply_map_place_0(_S1106, (*_S1107).primal_0);
    var _S1110 : s_paramCtx_s_bwdCallableCtx_map_place_0;
    _S1110.value0_77 = (*_S1107).primal_0;
    var _S1111 : s_bwdCallableCtx_map_place_0 = s_bwdCallableCtx_map_place_0( _S1110, _S1109.value1_24 );
    var _S1112 : vec3<f32> = (*_S1107).differential_0;
    s_bwdProp_map_place_0(_S1111, &(_S1112), _S1108);
    (*_S1107).differential_0 = _S1112;
    return;
}

fn path_word_0( path_0 : u32,  which_0 : u32) -> u32
{
    return paths_0[which_0 * launch_0.room_0 + path_0];
}

fn path_vector_0( path_1 : u32,  which_1 : ptr<function, u32>) -> vec3<f32>
{
    var _S1113 : u32 = (*which_1) + u32(3);
    (*which_1) = _S1113;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_1, _S1113 - u32(3)), path_word_0(path_1, _S1113 - u32(2)), path_word_0(path_1, _S1113 - u32(1))))));
}

fn path_vector_1( path_2 : u32,  which_2 : ptr<function, u32>) -> vec3<f32>
{
    var _S1114 : u32 = (*which_2) + u32(3);
    (*which_2) = _S1114;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_2, _S1114 - u32(3)), path_word_0(path_2, _S1114 - u32(2)), path_word_0(path_2, _S1114 - u32(1))))));
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
     v_rest_0 : f32,
     w_rest_0 : f32,
};

fn exact_place_0( triangle_1 : u32,  v_1 : f32,  w_1 : f32) -> Place_0
{
    var place_2 : Place_0;
    place_2.triangle_0 = triangle_1;
    place_2.v_0 = v_1;
    place_2.w_0 = w_1;
    place_2.v_rest_0 = 0.0f;
    place_2.w_rest_0 = 0.0f;
    return place_2;
}

fn path_place_0( path_4 : u32,  which_4 : ptr<function, u32>) -> Place_0
{
    var _S1115 : u32 = (*which_4) + u32(5);
    (*which_4) = _S1115;
    return exact_place_0(path_word_0(path_4, _S1115 - u32(5)), (bitcast<f32>((path_word_0(path_4, _S1115 - u32(4))))) + (bitcast<f32>((path_word_0(path_4, _S1115 - u32(2))))), (bitcast<f32>((path_word_0(path_4, _S1115 - u32(3))))) + (bitcast<f32>((path_word_0(path_4, _S1115 - u32(1))))));
}

struct ByRay_0
{
     drift_0 : vec3<f32>,
     direction_0 : vec3<f32>,
};

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_1 : vec3<f32>,
     place_3 : Place_0,
     key_0 : vec2<u32>,
     adjoint_0 : vec3<f32>,
     distance_0 : f32,
     by_ray_0 : ByRay_0,
};

fn load_0( number_of_path_0 : u32) -> Path_0
{
    var at_4 : u32 = u32(1);
    var path_5 : Path_0;
    var _S1116 : vec3<f32> = path_vector_0(number_of_path_0, &(at_4));
    path_5.adjoint_0 = _S1116;
    path_5.distance_0 = 0.0f;
    var _S1117 : vec3<f32> = vec3<f32>(0.0f);
    path_5.by_ray_0.direction_0 = _S1117;
    path_5.by_ray_0.drift_0 = _S1117;
    var _S1118 : vec3<f32> = path_changing_0(number_of_path_0, &(at_4));
    path_5.throughput_0 = _S1118;
    var _S1119 : vec3<f32> = path_changing_0(number_of_path_0, &(at_4));
    path_5.direction_1 = _S1119;
    var _S1120 : Place_0 = path_place_0(number_of_path_0, &(at_4));
    path_5.place_3 = _S1120;
    path_5.key_0 = vec2<u32>(path_word_0(number_of_path_0, at_4), path_word_0(number_of_path_0, at_4 + u32(1)));
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

struct Reflected_0
{
     direct_0 : vec3<f32>,
     onward_0 : vec3<f32>,
     wo_0 : vec3<f32>,
     is_specular_0 : bool,
     factor_0 : f32,
     distance_1 : f32,
     by_ray_1 : ByRay_0,
};

fn nothing_reflected_0() -> Reflected_0
{
    var reflected_0 : Reflected_0;
    var _S1121 : vec3<f32> = vec3<f32>(0.0f);
    var _S1122 : vec3<f32> = still_0(_S1121);
    reflected_0.direct_0 = _S1122;
    reflected_0.onward_0 = _S1122;
    reflected_0.wo_0 = vec3<f32>(0.0f, 0.0f, 1.0f);
    reflected_0.is_specular_0 = false;
    reflected_0.distance_1 = 0.0f;
    reflected_0.factor_0 = 0.0f;
    reflected_0.by_ray_1.direction_0 = _S1121;
    reflected_0.by_ray_1.drift_0 = _S1121;
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
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_3));
}

fn primitive_vector_0( at_5 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_0[at_5], primitives_0[at_5 + u32(1)], primitives_0[at_5 + u32(2)]);
}

fn position_of_0( place_4 : Place_0) -> vec3<f32>
{
    var at_6 : u32 = u32(9) * place_4.triangle_0;
    var a_4 : vec3<f32> = primitive_vector_0(at_6);
    return a_4 + (primitive_vector_0(at_6 + u32(3)) - a_4) * vec3<f32>((place_4.v_0 + place_4.v_rest_0)) + (primitive_vector_0(at_6 + u32(6)) - a_4) * vec3<f32>((place_4.w_0 + place_4.w_rest_0));
}

fn cross_of_0( triangle_4 : u32) -> vec3<f32>
{
    var at_7 : u32 = u32(9) * triangle_4;
    var a_5 : vec3<f32> = primitive_vector_0(at_7);
    return cross(primitive_vector_0(at_7 + u32(3)) - a_5, primitive_vector_0(at_7 + u32(6)) - a_5);
}

fn unit_0( v_2 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_2 / vec3<f32>(max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z))));
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

fn surface_at_0( place_6 : Place_0,  direction_2 : vec3<f32>) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.place_5 = place_6;
    surface_0.shape_0 = shape_of_0(place_6.triangle_0);
    var _S1123 : vec3<f32> = position_of_0(place_6);
    surface_0.exact_0 = _S1123;
    surface_0.position_0 = _S1123;
    var _S1124 : vec3<f32> = unit_0(cross_of_0(place_6.triangle_0));
    surface_0.face_normal_0 = _S1124;
    surface_0.outward_0 = _S1124;
    var seen_0 : f32;
    if((dot(_S1124, direction_2)) > 0.0f)
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
        var a_6 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_1));
        var b_3 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_1 + u32(1)));
        var c_0 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_1 + u32(2)));
        if((dot(a_6 + b_3 + c_0, surface_0.face_normal_0)) < 0.0f)
        {
            seen_0 = - seen_0;
        }
        surface_0.outward_0 = normalize(a_6 + (b_3 - a_6) * vec3<f32>(place_6.v_0) + (c_0 - a_6) * vec3<f32>(place_6.w_0));
    }
    surface_0.is_front_0 = seen_0 > 0.0f;
    return surface_0;
}

fn material_of_0( surface_1 : Surface_0) -> u32
{
    var _S1125 : u32;
    if(surface_1.is_front_0)
    {
        _S1125 = u32(2);
    }
    else
    {
        _S1125 = u32(3);
    }
    return word_0(surface_1.shape_0 + _S1125);
}

fn no_numbers_0() -> Numbers_0
{
    var numbers_2 : Numbers_0;
    var _S1126 : vec3<f32> = vec3<f32>(0.0f);
    numbers_2.k_0 = _S1126;
    numbers_2.eta_0 = _S1126;
    numbers_2.specular_reflectance_0 = _S1126;
    numbers_2.diffuse_reflectance_0 = _S1126;
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
    var _S1127 : vec4<f32> = vec4<f32>(0.0f);
    lookup_0.by_second_0 = _S1127;
    lookup_0.by_first_0 = _S1127;
    return lookup_0;
}

struct Corners2_0
{
     a_7 : vec2<f32>,
     b_4 : vec2<f32>,
     c_1 : vec2<f32>,
};

fn Corners2_x24init_0( a_8 : vec2<f32>,  b_5 : vec2<f32>,  c_2 : vec2<f32>) -> Corners2_0
{
    var _S1128 : Corners2_0;
    _S1128.a_7 = a_8;
    _S1128.b_4 = b_5;
    _S1128.c_1 = c_2;
    return _S1128;
}

fn precise_0( at_8 : u32) -> f32
{
    return number_0(at_8) + number_0(at_8 + u32(1));
}

fn uvs_of_0( triangle_5 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f32>(0.0f, 0.0f), vec2<f32>(1.0f, 0.0f), vec2<f32>(0.0f, 1.0f));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_5) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_9 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_5) + u32(1));
    uvs_0.a_7 = vec2<f32>(precise_0(at_9), precise_0(at_9 + u32(2)));
    uvs_0.b_4 = vec2<f32>(precise_0(at_9 + u32(4)), precise_0(at_9 + u32(6)));
    uvs_0.c_1 = vec2<f32>(precise_0(at_9 + u32(8)), precise_0(at_9 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_10 : u32) -> vec3<f32>
{
    return vec3<f32>(precise_0(at_10), precise_0(at_10 + u32(2)), precise_0(at_10 + u32(4)));
}

fn floor_of_0( x_14 : f32) -> i32
{
    return i32(clamp(floor(x_14), -1.0e+09f, 1.0e+09f));
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
     value_5 : vec2<f32>,
     by_first_1 : vec2<f32>,
     by_second_1 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_7 : Point_0) -> Lookup_0
{
    var way_0 : vec2<f32> = place_7.value_5 - floor(place_7.value_5);
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_0;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S1129 : f32 = back_0.x;
    var _S1130 : f32 = back_0.y;
    var _S1131 : f32 = way_0.x;
    var _S1132 : f32 = way_0.y;
    lookup_1.weights_1 = vec4<f32>(_S1129 * _S1130, _S1131 * _S1130, _S1129 * _S1132, _S1131 * _S1132);
    var by_x_0 : vec4<f32> = vec4<f32>(- _S1130, _S1130, - _S1132, _S1132);
    var by_y_0 : vec4<f32> = vec4<f32>(- _S1129, - _S1131, _S1129, _S1131);
    lookup_1.by_first_0 = by_x_0 * vec4<f32>(place_7.by_first_1.x) + by_y_0 * vec4<f32>(place_7.by_first_1.y);
    lookup_1.by_second_0 = by_x_0 * vec4<f32>(place_7.by_second_1.x) + by_y_0 * vec4<f32>(place_7.by_second_1.y);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_1 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var size_0 : vec2<f32> = vec2<f32>(f32(width_1), f32(height_0));
    var place_8 : vec2<f32> = uv_0.value_5 * size_0;
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_8.y), height_0, wrap_1);
        var _S1133 : u32 = row_0 * u32(width_1);
        var _S1134 : u32 = wrapped_0(floor_of_0(place_8.x), width_1, wrap_1);
        return one_texel_0(_S1133 + _S1134);
    }
    var centred_0 : Point_0;
    var _S1135 : vec2<f32> = place_8 - vec2<f32>(0.5f);
    centred_0.value_5 = _S1135;
    centred_0.by_first_1 = uv_0.by_first_1 * size_0;
    centred_0.by_second_1 = uv_0.by_second_1 * size_0;
    var x_15 : i32 = floor_of_0(_S1135.x);
    var y_5 : i32 = floor_of_0(_S1135.y);
    var _S1136 : u32 = wrapped_0(y_5, height_0, wrap_1);
    var _S1137 : u32 = u32(width_1);
    var first_1 : u32 = _S1136 * _S1137;
    var _S1138 : u32 = wrapped_0(y_5 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S1138 * _S1137;
    var left_0 : u32 = wrapped_0(x_15, width_1, wrap_1);
    var right_0 : u32 = wrapped_0(x_15 + i32(1), width_1, wrap_1);
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
        lookup_2.by_first_0 = vec4<f32>(-1.0f, 1.0f, 0.0f, 0.0f);
        lookup_2.by_second_0 = vec4<f32>(-1.0f, 0.0f, 1.0f, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_9.triangle_0);
    var by_v_0 : vec2<f32> = uvs_1.b_4 - uvs_1.a_7;
    var by_w_0 : vec2<f32> = uvs_1.c_1 - uvs_1.a_7;
    var _S1139 : u32 = texture_1 + u32(6);
    var to_u_0 : vec3<f32> = row_at_0(_S1139);
    var to_v_0 : vec3<f32> = row_at_0(_S1139 + u32(6));
    var uv_1 : Point_0;
    var _S1140 : vec3<f32> = vec3<f32>(uvs_1.a_7 + by_v_0 * vec2<f32>((place_9.v_0 + place_9.v_rest_0)) + by_w_0 * vec2<f32>((place_9.w_0 + place_9.w_rest_0)), 1.0f);
    uv_1.value_5 = vec2<f32>(dot(_S1140, to_u_0), dot(_S1140, to_v_0));
    var _S1141 : vec2<f32> = to_u_0.xy;
    var _S1142 : vec2<f32> = to_v_0.xy;
    uv_1.by_first_1 = vec2<f32>(dot(by_v_0, _S1141), dot(by_v_0, _S1142));
    uv_1.by_second_1 = vec2<f32>(dot(by_w_0, _S1141), dot(by_w_0, _S1142));
    if(kind_1 == u32(1))
    {
        var _S1143 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S1143;
    }
    var half_of_period_0 : vec2<f32> = uv_1.value_5 - floor(uv_1.value_5);
    var _S1144 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S1144 = i32(1);
    }
    else
    {
        _S1144 = i32(0);
    }
    return one_texel_0(u32(_S1144));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_2 : vec4<f32>) -> vec3<f32>
{
    var _S1145 : u32 = word_0(texture_2 + u32(1));
    var _S1146 : u32 = texture_2 + u32(19);
    var _S1147 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_6 : vec3<f32> = _S1147;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_11 : u32 = _S1146 + _S1145 * lookup_3.texels_0[k_1];
        var _S1148 : vec3<f32>;
        if(_S1145 == u32(1))
        {
            _S1148 = vec3<f32>(number_0(at_11));
        }
        else
        {
            _S1148 = vector_at_0(at_11);
        }
        var value_7 : vec3<f32> = value_6 + _S1148 * vec3<f32>(weights_2[k_1]);
        k_1 = k_1 + u32(1);
        value_6 = value_7;
    }
    return value_6;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_1);
}

fn shown_0( texture_4 : u32,  place_10 : Place_0) -> vec3<f32>
{
    var _S1149 : Lookup_0 = lookup_at_0(texture_4, place_10);
    return looked_up_0(texture_4, _S1149, vec2<f32>(0.0f));
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

fn lobe_at_0( record_3 : u32,  place_11 : Place_0) -> Lobe_0
{
    var lobe_5 : Lobe_0;
    lobe_5.record_0 = record_3;
    var is_black_0 : bool = record_3 == u32(4294967295);
    var _S1150 : u32;
    if(is_black_0)
    {
        _S1150 = u32(0);
    }
    else
    {
        _S1150 = word_0(record_3);
    }
    lobe_5.kind_0 = _S1150;
    if(is_black_0)
    {
        _S1150 = u32(1);
    }
    else
    {
        _S1150 = word_0(record_3 + u32(1));
    }
    lobe_5.distribution_0 = _S1150;
    lobe_5.numbers_0 = no_numbers_0();
    if(is_black_0)
    {
        _S1150 = u32(0);
    }
    else
    {
        _S1150 = word_0(record_3 + u32(4));
    }
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < _S1150)
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
        var colour_2 : vec3<f32> = shown_0(texture_5, place_11);
        var _S1151 : vec3<f32> = value_of_0(colour_2);
        var _S1152 : Numbers_0 = lobe_5.numbers_0;
        set_slot_0(&(_S1152), slot_1, _S1151);
        lobe_5.numbers_0 = _S1152;
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
    var tangent_0 : vec3<f32> = vector_at_0(tangents_0 + u32(3) * word_0(triangle_record_0(surface_2.place_5.triangle_0) + u32(1)));
    var across_0 : vec3<f32> = cross(tangent_0, surface_2.outward_0);
    var _S1153 : vec3<f32>;
    if((dot(across_0, across_0)) > 0.0f)
    {
        _S1153 = tangent_0;
    }
    else
    {
        _S1153 = vec3<f32>(0.0f);
    }
    return _S1153;
}

fn axes_along_0( n_2 : vec3<f32>,  tangent_1 : vec3<f32>,  is_front_1 : bool) -> Axes_0
{
    var axes_0 : Axes_0;
    var _S1154 : vec3<f32>;
    if(is_front_1)
    {
        _S1154 = n_2;
    }
    else
    {
        _S1154 = (vec3<f32>(0) - n_2);
    }
    axes_0.n_0 = _S1154;
    var _S1155 : vec3<f32> = normalize(tangent_1 - n_2 * vec3<f32>(dot(n_2, tangent_1)));
    axes_0.s_0 = _S1155;
    axes_0.t_0 = cross(n_2, _S1155);
    return axes_0;
}

fn axes_around_0( n_3 : vec3<f32>,  is_front_2 : bool) -> Axes_0
{
    var axes_1 : Axes_0;
    var _S1156 : vec3<f32>;
    if(is_front_2)
    {
        _S1156 = n_3;
    }
    else
    {
        _S1156 = (vec3<f32>(0) - n_3);
    }
    axes_1.n_0 = _S1156;
    var _S1157 : f32 = n_3.z;
    var sign_1 : f32;
    if(_S1157 < -0.00000999999974738f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var a_9 : f32 = -1.0f / (sign_1 + _S1157);
    var _S1158 : f32 = n_3.x;
    var _S1159 : f32 = n_3.y;
    var b_6 : f32 = _S1158 * _S1159 * a_9;
    axes_1.s_0 = vec3<f32>(1.0f + sign_1 * _S1158 * _S1158 * a_9, sign_1 * b_6, - sign_1 * _S1158);
    axes_1.t_0 = vec3<f32>(b_6, sign_1 + _S1159 * _S1159 * a_9, - _S1159);
    return axes_1;
}

fn to_local_0( axes_2 : Axes_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(axes_2.s_0, v_3), dot(axes_2.t_0, v_3), dot(axes_2.n_0, v_3));
}

fn towards_viewer_0( axes_3 : Axes_0,  direction_3 : vec3<f32>) -> vec3<f32>
{
    var wi_0 : vec3<f32> = (vec3<f32>(0) - to_local_0(axes_3, direction_3));
    return vec3<f32>(wi_0.x, wi_0.y, max(abs(wi_0.z), 9.999999960041972e-13f));
}

struct Vertex_0
{
     surface_3 : Surface_0,
     axes_4 : Axes_0,
     lobe_6 : Lobe_0,
     wi_1 : vec3<f32>,
};

fn vertex_at_0( surface_4 : Surface_0,  material_0 : u32,  direction_4 : vec3<f32>) -> Vertex_0
{
    var vertex_0 : Vertex_0;
    vertex_0.surface_3 = surface_4;
    var _S1160 : Lobe_0 = lobe_at_0(material_0, surface_4.place_5);
    vertex_0.lobe_6 = _S1160;
    var tangent_2 : vec3<f32> = tangent_at_0(surface_4);
    if((any((tangent_2 != vec3<f32>(0.0f)))))
    {
        vertex_0.axes_4 = axes_along_0(surface_4.outward_0, tangent_2, surface_4.is_front_0);
    }
    else
    {
        vertex_0.axes_4 = axes_around_0(surface_4.outward_0, surface_4.is_front_0);
    }
    vertex_0.wi_1 = towards_viewer_0(vertex_0.axes_4, direction_4);
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
    var distance_2 : f32 = sqrt(squared_2);
    if(distance_2 <= radius_0)
    {
        return 0.25f * area_0 / max(radius_0 * radius_0, 1.00000000317107685e-30f);
    }
    var cosine_1 : f32 = clamp(dot(axis_0, offset_0) / distance_2, -1.0f, 1.0f);
    var sine_0 : f32 = sqrt(1.0f - cosine_1 * cosine_1);
    var tilt_0 : f32 = radius_0 / distance_2;
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
        return max(dot(vector_at_0(node_0 + u32(8)), offset_0) / distance_2, 0.0f) / squared_2;
    }
    var _S1161 : f32 = min(highest_0, 1.0f);
    return area_0 * _S1161 * _S1161 / (2.0f * (_S1161 - max(lowest_0, -1.0f)) * squared_2);
}

fn is_sampled_well_0( position_1 : vec3<f32>) -> bool
{
    var _S1162 : bool;
    if((word_0(u32(6))) != u32(1))
    {
        _S1162 = true;
    }
    else
    {
        _S1162 = (word_0(u32(2))) == u32(0);
    }
    if(_S1162)
    {
        return false;
    }
    var record_5 : u32 = emitter_record_0(u32(0));
    if(is_area_0(record_5))
    {
        _S1162 = (node_seen_0(word_0(record_5 + u32(5)), position_1)) < 1.0f;
    }
    else
    {
        _S1162 = false;
    }
    return _S1162;
}

fn has_smooth_0( lobe_7 : Lobe_0) -> bool
{
    return (lobe_7.kind_0) != u32(1);
}

struct Pulled_0
{
     numbers_4 : Numbers_0,
     axes_5 : Axes_0,
     wi_2 : vec3<f32>,
     position_2 : vec3<f32>,
};

fn nothing_pulled_0() -> Pulled_0
{
    var pulled_0 : Pulled_0;
    pulled_0.numbers_4 = no_numbers_0();
    var _S1163 : vec3<f32> = vec3<f32>(0.0f);
    pulled_0.position_2 = _S1163;
    pulled_0.wi_2 = _S1163;
    pulled_0.axes_5.n_0 = _S1163;
    pulled_0.axes_5.t_0 = _S1163;
    pulled_0.axes_5.s_0 = _S1163;
    return pulled_0;
}

fn largest_cosine_0( position_3 : vec3<f32>,  normal_0 : vec3<f32>,  centre_0 : vec3<f32>,  radius_1 : f32) -> f32
{
    var offset_1 : vec3<f32> = centre_0 - position_3;
    var distance_3 : f32 = length(offset_1);
    if(distance_3 <= radius_1)
    {
        return 1.0f;
    }
    var cosine_2 : f32 = dot(offset_1, normal_0) / distance_3;
    var sine_ball_0 : f32 = radius_1 / distance_3;
    var cosine_ball_0 : f32 = sqrt(max(1.0f - sine_ball_0 * sine_ball_0, 0.0f));
    if(cosine_2 >= cosine_ball_0)
    {
        return 1.0f;
    }
    return max(cosine_2 * cosine_ball_0 + sqrt(max(1.0f - cosine_2 * cosine_2, 0.0f)) * sine_ball_0 + 9.99999997475242708e-07f, 0.0f);
}

fn emitter_view_0( emitter_1 : u32,  position_4 : vec3<f32>,  normal_1 : vec3<f32>) -> f32
{
    var record_6 : u32 = emitter_record_0(emitter_1);
    if(!is_area_0(record_6))
    {
        return 3.14159274101257324f;
    }
    return node_seen_0(word_0(record_6 + u32(5)), position_4) * largest_cosine_0(position_4, normal_1, vector_at_0(record_6 + u32(8)), number_0(record_6 + u32(11)));
}

struct Choice_0
{
     position_5 : vec3<f32>,
     normal_2 : vec3<f32>,
     all_0 : f32,
     lit_0 : f32,
};

fn light_of_0( emitter_2 : u32,  choice_0 : Choice_0,  can_light_0 : ptr<function, f32>) -> f32
{
    var view_0 : f32 = emitter_view_0(emitter_2, choice_0.position_5, choice_0.normal_2);
    var _S1164 : f32;
    if(view_0 > 0.0f)
    {
        _S1164 = 1.0f;
    }
    else
    {
        _S1164 = 0.0f;
    }
    (*can_light_0) = _S1164;
    return view_0 * number_0(emitter_record_0(emitter_2) + u32(2));
}

fn light_of_1( emitter_3 : u32,  choice_1 : Choice_0,  can_light_1 : ptr<function, f32>) -> f32
{
    var view_1 : f32 = emitter_view_0(emitter_3, choice_1.position_5, choice_1.normal_2);
    var _S1165 : f32;
    if(view_1 > 0.0f)
    {
        _S1165 = 1.0f;
    }
    else
    {
        _S1165 = 0.0f;
    }
    (*can_light_1) = _S1165;
    return view_1 * number_0(emitter_record_0(emitter_3) + u32(2));
}

fn choice_at_0( position_6 : vec3<f32>,  normal_3 : vec3<f32>,  alike_0 : bool) -> Choice_0
{
    var choice_2 : Choice_0;
    choice_2.position_5 = position_6;
    choice_2.normal_2 = normal_3;
    choice_2.all_0 = 0.0f;
    choice_2.lit_0 = 0.0f;
    var count_1 : u32 = word_0(u32(6));
    var _S1166 : bool;
    if(alike_0)
    {
        _S1166 = true;
    }
    else
    {
        _S1166 = (word_0(u32(5))) != u32(0);
    }
    if(_S1166)
    {
        _S1166 = true;
    }
    else
    {
        _S1166 = count_1 < u32(2);
    }
    if(_S1166)
    {
        _S1166 = true;
    }
    else
    {
        _S1166 = count_1 > u32(32);
    }
    if(_S1166)
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
        var _S1167 : f32 = light_of_1(i_1, choice_2, &(can_light_2));
        choice_2.all_0 = choice_2.all_0 + _S1167;
        choice_2.lit_0 = choice_2.lit_0 + can_light_2;
        i_1 = i_1 + u32(1);
    }
    if((choice_2.all_0) > 0.0f)
    {
        _S1166 = (choice_2.all_0) < 3.00000000549775576e+38f;
    }
    else
    {
        _S1166 = false;
    }
    if(!_S1166)
    {
        choice_2.all_0 = 0.0f;
    }
    return choice_2;
}

fn limit_at_0( which_5 : u32) -> f32
{
    return primitives_0[word_0(u32(15)) + which_5];
}

fn product_2( a_10 : u32,  b_7 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_10 & (u32(65535)));
    var a1_0 : u32 = (a_10 >> (u32(16)));
    var b0_0 : u32 = (b_7 & (u32(65535)));
    var b1_0 : u32 = (b_7 >> (u32(16)));
    var low_0 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_0 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_0 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_11 : vec2<u32>,  b_8 : vec2<u32>) -> vec2<u32>
{
    var _S1168 : u32 = a_11.x;
    var _S1169 : u32 = b_8.x;
    var low_1 : vec2<u32> = product_2(_S1168, _S1169);
    return vec2<u32>(low_1.x, low_1.y + _S1168 * b_8.y + a_11.y * _S1169);
}

fn plus_0( a_12 : vec2<u32>,  b_9 : vec2<u32>) -> vec2<u32>
{
    var _S1170 : u32 = a_12.x;
    var low_2 : u32 = _S1170 + b_9.x;
    var _S1171 : u32 = a_12.y + b_9.y;
    var _S1172 : i32;
    if(low_2 < _S1170)
    {
        _S1172 = i32(1);
    }
    else
    {
        _S1172 = i32(0);
    }
    return vec2<u32>(low_2, _S1171 + u32(_S1172));
}

fn shifted_xor_0( x_16 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S1173 : u32 = x_16.y;
    return (x_16 ^ (vec2<u32>(((((x_16.x) >> (by_0))) | (((_S1173 << ((u32(32) - by_0)))))), (_S1173 >> (by_0)))));
}

fn mix_0( x_17 : vec2<u32>) -> vec2<u32>
{
    return shifted_xor_0(times_0(shifted_xor_0(times_0(shifted_xor_0(x_17, u32(30)), vec2<u32>(u32(484763065), u32(3210233709))), u32(27)), vec2<u32>(u32(321982955), u32(2496678331))), u32(31));
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
        var _S1174 : f32 = f32(count_2);
        (*probability_2) = 1.0f / _S1174;
        return min(u32(u_0 * _S1174), count_2 - u32(1));
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
        var _S1175 : u32 = i_2 + u32(1);
        found_0 = found_1;
        i_2 = _S1175;
        rest_1 = rest_2;
    }
    return found_0;
}

fn place_at_0( triangle_6 : u32,  v_4 : f32,  w_2 : f32) -> Place_0
{
    return exact_place_0(triangle_6, v_4, w_2);
}

fn angle_of_0( x_18 : f32,  y_6 : f32) -> f32
{
    var _S1176 : f32 = abs(x_18);
    var _S1177 : f32 = abs(y_6);
    var _S1178 : f32 = min(_S1176, _S1177);
    var _S1179 : f32 = max(_S1176, _S1177);
    var is_steep_2 : bool = _S1178 > (0.41421356797218323f * _S1179);
    var above_2 : f32;
    if(is_steep_2)
    {
        above_2 = _S1178 - _S1179;
    }
    else
    {
        above_2 = _S1178;
    }
    var below_2 : f32;
    if(is_steep_2)
    {
        below_2 = _S1178 + _S1179;
    }
    else
    {
        below_2 = _S1179;
    }
    if(below_2 > 0.0f)
    {
    }
    else
    {
        below_2 = 1.0f;
    }
    var t_3 : f32 = above_2 / below_2;
    var z_2 : f32 = t_3 * t_3;
    var angle_2 : f32 = (((0.08053744584321976f * z_2 - 0.13877685368061066f) * z_2 + 0.19977711141109467f) * z_2 - 0.33332949876785278f) * z_2 * t_3 + t_3;
    var angle_3 : f32;
    if(is_steep_2)
    {
        angle_3 = angle_2 + 0.78539818525314331f;
    }
    else
    {
        angle_3 = angle_2;
    }
    if(_S1177 > _S1176)
    {
        angle_3 = 1.57079637050628662f - angle_3;
    }
    if(x_18 < 0.0f)
    {
        angle_3 = 3.14159274101257324f - angle_3;
    }
    if(y_6 < 0.0f)
    {
        above_2 = - angle_3;
    }
    else
    {
        above_2 = angle_3;
    }
    return above_2;
}

fn solid_angle_of_0( a_13 : vec3<f32>,  b_10 : vec3<f32>,  c_3 : vec3<f32>) -> f32
{
    var la_0 : f32 = length(a_13);
    var lb_0 : f32 = length(b_10);
    var lc_0 : f32 = length(c_3);
    var normal_4 : vec3<f32> = cross(b_10 - a_13, c_3 - a_13);
    var volume_0 : f32 = - dot(a_13, normal_4);
    if(!(volume_0 > (9.99999997475242708e-07f * max(max(la_0, lb_0), lc_0) * length(normal_4))))
    {
        return 0.0f;
    }
    return 2.0f * angle_of_0(la_0 * lb_0 * lc_0 + dot(a_13, b_10) * lc_0 + dot(b_10, c_3) * la_0 + dot(c_3, a_13) * lb_0, volume_0);
}

fn complex_product_0( a_14 : vec2<f32>,  b_11 : vec2<f32>) -> vec2<f32>
{
    var _S1180 : f32 = a_14.x;
    var _S1181 : f32 = b_11.x;
    var _S1182 : f32 = a_14.y;
    var _S1183 : f32 = b_11.y;
    return vec2<f32>(_S1180 * _S1181 - _S1182 * _S1183, _S1180 * _S1183 + _S1182 * _S1181);
}

struct SeenRectangle_0
{
     x_19 : vec2<f32>,
     y_7 : vec2<f32>,
     z_3 : f32,
     solid_angle_0 : f32,
     start_0 : vec2<f32>,
     inverse_to_line_0 : vec2<f32>,
};

fn seen_rectangle_0( at_12 : u32,  viewpoint_1 : vec3<f32>) -> SeenRectangle_0
{
    var offset_2 : vec3<f32> = vector_at_0(at_12) - viewpoint_1;
    var x0_0 : f32 = dot(vector_at_0(at_12 + u32(3)), offset_2);
    var y0_0 : f32 = dot(vector_at_0(at_12 + u32(6)), offset_2);
    var x1_0 : f32 = x0_0 + number_0(at_12 + u32(12));
    var y1_0 : f32 = y0_0 + number_0(at_12 + u32(13));
    var seen_1 : SeenRectangle_0;
    seen_1.x_19 = vec2<f32>(x0_0, x1_0);
    seen_1.y_7 = vec2<f32>(y0_0, y1_0);
    var _S1184 : f32 = - dot(vector_at_0(at_12 + u32(9)), offset_2);
    seen_1.z_3 = _S1184;
    var a_15 : vec3<f32> = vec3<f32>(x0_0, y0_0, _S1184);
    var b_12 : vec3<f32> = vec3<f32>(x1_0, y0_0, _S1184);
    var c_4 : vec3<f32> = vec3<f32>(x0_0, y1_0, _S1184);
    var d_2 : vec3<f32> = vec3<f32>(x1_0, y1_0, _S1184);
    var _S1185 : f32 = length(a_15);
    var _S1186 : f32 = length(c_4);
    var _S1187 : f32;
    if(_S1184 > (9.99999997475242708e-07f * max(max(_S1185, length(b_12)), max(_S1186, length(d_2)))))
    {
        _S1187 = solid_angle_of_0(a_15, c_4, b_12) + solid_angle_of_0(d_2, b_12, c_4);
    }
    else
    {
        _S1187 = 0.0f;
    }
    seen_1.solid_angle_0 = _S1187;
    var z2_2 : f32 = seen_1.z_3 * seen_1.z_3;
    var at_first_0 : vec2<f32> = complex_product_0(vec2<f32>(x0_0 * y1_0, seen_1.z_3 * _S1186), vec2<f32>(- x0_0 * y0_0, seen_1.z_3 * _S1185));
    var to_line_0 : vec2<f32> = sqrt(seen_1.y_7 * seen_1.y_7 + vec2<f32>(z2_2));
    seen_1.start_0 = vec2<f32>(at_first_0.x, - at_first_0.y) * vec2<f32>((1.0f / ((x0_0 * x0_0 + z2_2) * to_line_0.x * to_line_0.y)));
    seen_1.inverse_to_line_0 = vec2<f32>(1.0f) / to_line_0;
    return seen_1;
}

fn sine_cosine_0( angle_4 : f32) -> vec2<f32>
{
    var quarters_0 : f32 = floor(angle_4 * 0.63661974668502808f + 0.5f);
    var x_20 : f32 = angle_4 - quarters_0 * 1.5703125f - quarters_0 * 0.00048375129699707f - quarters_0 * 7.54979012640433211e-08f;
    var z_4 : f32 = x_20 * x_20;
    var sine_1 : f32 = ((-0.00019515295571182f * z_4 + 0.00833216123282909f) * z_4 - 0.16666655242443085f) * z_4 * x_20 + x_20;
    var cosine_3 : f32 = ((0.00002443315679557f * z_4 - 0.00138873164542019f) * z_4 + 0.04166664555668831f) * z_4 * z_4 - 0.5f * z_4 + 1.0f;
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
    var at_13 : vec2<f32> = complex_product_0(seen_2.start_0, vec2<f32>(turn_0.y, turn_0.x));
    var _S1188 : f32 = seen_2.y_7.x;
    var _S1189 : f32 = seen_2.inverse_to_line_0.x;
    var _S1190 : f32 = seen_2.y_7.y;
    var n_4 : f32 = - at_13.x * _S1188 * _S1189 - _S1190 * seen_2.inverse_to_line_0.y;
    var _S1191 : f32 = at_13.y;
    var flat_0 : f32 = _S1191 * seen_2.z_3 * _S1189;
    var size_1 : f32 = seen_2.z_3 * abs(_S1191) / sqrt(max(n_4 * n_4 - flat_0 * flat_0, 0.0f));
    var _S1192 : f32;
    if((n_4 * _S1191) < 0.0f)
    {
        _S1192 = - size_1;
    }
    else
    {
        _S1192 = size_1;
    }
    var x_21 : f32 = clamp(_S1192, seen_2.x_19.x, seen_2.x_19.y);
    var squared_3 : f32 = x_21 * x_21 + seen_2.z_3 * seen_2.z_3;
    var h_0 : vec2<f32> = seen_2.y_7 / sqrt(vec2<f32>(squared_3) + seen_2.y_7 * seen_2.y_7);
    var _S1193 : f32 = h_0.x;
    var sine_2 : f32 = _S1193 + u_1.y * (h_0.y - _S1193);
    return vec2<f32>(x_21, clamp(sine_2 * sqrt(squared_3 / max((1.0f - sine_2) * (1.0f + sine_2), 0.0f)), _S1188, _S1190));
}

fn rectangle_face_0( at_14 : u32,  place_12 : vec2<f32>,  weights_3 : ptr<function, vec2<f32>>) -> u32
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
        var row_1 : u32 = at_14 + u32(14) + u32(6) * face_0;
        var _S1194 : f32 = place_12.x;
        var _S1195 : f32 = place_12.y;
        var v_5 : f32 = number_0(row_1) + number_0(row_1 + u32(1)) * _S1194 + number_0(row_1 + u32(2)) * _S1195;
        var w_3 : f32 = number_0(row_1 + u32(3)) + number_0(row_1 + u32(4)) * _S1194 + number_0(row_1 + u32(5)) * _S1195;
        var _S1196 : f32 = min(min(v_5, w_3), 1.0f - v_5 - w_3);
        if(_S1196 > best_0)
        {
            (*weights_3)[i32(0)] = clamp(v_5, 0.0f, 1.0f);
            (*weights_3)[i32(1)] = clamp(w_3, 0.0f, 1.0f - (*weights_3).x);
            best_0 = _S1196;
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
    var _S1197 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(2)), viewpoint_2);
    var _S1198 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(3)), viewpoint_2);
    var seen_3 : vec2<f32> = vec2<f32>(_S1197, _S1198);
    var sum_3 : f32 = _S1197 + _S1198;
    var _S1199 : vec2<f32>;
    if(sum_3 > 0.0f)
    {
        _S1199 = seen_3 / vec2<f32>(sum_3);
    }
    else
    {
        _S1199 = vec2<f32>(0.0f);
    }
    return _S1199;
}

struct Corners_0
{
     a_16 : vec3<f32>,
     b_13 : vec3<f32>,
     c_5 : vec3<f32>,
};

fn corners_from_0( record_8 : u32,  face_2 : u32,  viewpoint_3 : vec3<f32>) -> Corners_0
{
    var at_15 : u32 = u32(9) * emitter_triangle_0(record_8, face_2);
    var corners_0 : Corners_0;
    corners_0.a_16 = primitive_vector_0(at_15) - viewpoint_3;
    corners_0.b_13 = primitive_vector_0(at_15 + u32(3)) - viewpoint_3;
    corners_0.c_5 = primitive_vector_0(at_15 + u32(6)) - viewpoint_3;
    return corners_0;
}

fn face_solid_angle_0( record_9 : u32,  face_3 : u32,  viewpoint_4 : vec3<f32>) -> f32
{
    var corners_1 : Corners_0 = corners_from_0(record_9, face_3, viewpoint_4);
    return solid_angle_of_0(corners_1.a_16, corners_1.b_13, corners_1.c_5);
}

fn unit_across_0( v_6 : vec3<f32>,  axis_1 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_6 - axis_1 * vec3<f32>(dot(v_6, axis_1)));
}

fn along_0( from_0 : vec3<f32>,  to_0 : vec3<f32>,  cosine_4 : f32) -> vec3<f32>
{
    var _S1200 : f32 = clamp(cosine_4, -1.0f, 1.0f);
    return from_0 * vec3<f32>(_S1200) + unit_across_0(to_0, from_0) * vec3<f32>(sqrt((1.0f - _S1200) * (1.0f + _S1200)));
}

fn triangle_direction_0( a_17 : vec3<f32>,  b_14 : vec3<f32>,  c_6 : vec3<f32>,  area_1 : f32,  u_2 : vec2<f32>) -> vec3<f32>
{
    var _S1201 : vec3<f32> = normalize(a_17);
    var _S1202 : vec3<f32> = normalize(b_14);
    var _S1203 : vec3<f32> = normalize(c_6);
    var ab_0 : vec3<f32> = normalize(cross(_S1201, _S1202));
    var ca_0 : vec3<f32> = normalize(cross(_S1203, _S1201));
    var sine_alpha_0 : f32 = length(cross(ab_0, ca_0));
    var cosine_alpha_0 : f32 = - dot(ab_0, ca_0);
    var part_0 : vec2<f32> = sine_cosine_0(u_2.x * area_1);
    var _S1204 : f32 = part_0.x;
    var _S1205 : f32 = part_0.y;
    var sine_phi_0 : f32 = _S1204 * cosine_alpha_0 - _S1205 * sine_alpha_0;
    var cosine_phi_0 : f32 = _S1205 * cosine_alpha_0 + _S1204 * sine_alpha_0;
    var k1_0 : f32 = cosine_phi_0 - cosine_alpha_0;
    var k2_0 : f32 = sine_phi_0 + sine_alpha_0 * dot(_S1201, _S1202);
    var between_1 : vec3<f32> = along_0(_S1201, _S1203, ((k2_0 * cosine_phi_0 - k1_0 * sine_phi_0) * cosine_alpha_0 - k2_0) / ((k2_0 * sine_phi_0 + k1_0 * cosine_phi_0) * sine_alpha_0));
    return along_0(_S1202, between_1, 1.0f - u_2.y * (1.0f - dot(between_1, _S1202)));
}

fn density_of_0( solid_angle_1 : f32,  normal_5 : vec3<f32>,  distance_4 : f32,  direction_5 : vec3<f32>) -> f32
{
    if(!(solid_angle_1 < 0.00100000004749745f))
    {
        return 1.0f;
    }
    return solid_angle_1 * 2.0f * distance_4 * distance_4 / abs(dot(normal_5, direction_5));
}

struct EmitterPoint_0
{
     place_13 : Place_0,
     pdf_2 : f32,
};

fn area_point_0( record_10 : u32,  from_1 : Surface_0,  key_4 : vec2<u32>,  dimension_3 : u32) -> EmitterPoint_0
{
    var total_0 : f32;
    var point_0 : EmitterPoint_0;
    point_0.pdf_2 = 0.0f;
    point_0.place_13 = place_at_0(u32(0), 0.0f, 0.0f);
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
            var face_4 : u32 = rectangle_face_0(rectangle_0, rectangle_place_0(seen_4, vec2<f32>(random_0(key_4, dimension_3), second_1)) - vec2<f32>(seen_4.x_19.x, seen_4.y_7.x), &(weights_4));
            point_0.place_13.triangle_0 = emitter_triangle_0(record_10, face_4);
            point_0.place_13.v_0 = weights_4.x;
            point_0.place_13.w_0 = weights_4.y;
            point_0.pdf_2 = 1.0f / seen_4.solid_angle_0;
            return point_0;
        }
    }
    var _S1206 : f32 = precise_random_0(key_4, dimension_3);
    var nodes_at_1 : u32 = word_0(record_10 + u32(5));
    var node_2 : u32 = nodes_at_1;
    var u_3 : f32 = _S1206;
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
        var _S1207 : f32 = shares_0.x;
        var _S1208 : f32 = shares_0.y;
        if(!((_S1207 + _S1208) > 0.0f))
        {
            return point_0;
        }
        var is_second_0 : bool;
        if(u_3 >= _S1207)
        {
            is_second_0 = _S1208 > 0.0f;
        }
        else
        {
            is_second_0 = false;
        }
        if(is_second_0)
        {
            u_3 = (u_3 - _S1207) / _S1208;
        }
        else
        {
            u_3 = min(u_3 / _S1207, 1.0f);
        }
        if(is_second_0)
        {
            total_0 = _S1208;
        }
        else
        {
            total_0 = _S1207;
        }
        var chosen_1 : f32 = chosen_0 * total_0;
        var _S1209 : i32;
        if(is_second_0)
        {
            _S1209 = i32(3);
        }
        else
        {
            _S1209 = i32(2);
        }
        node_2 = nodes_at_1 + u32(17) * word_0(node_2 + u32(_S1209));
        chosen_0 = chosen_1;
    }
    var first_2 : u32 = word_0(node_2);
    var _S1210 : u32 = word_0(node_2 + u32(1));
    var _S1211 : u32 = word_0(record_10 + u32(6));
    var k_2 : u32 = first_2;
    total_0 = 0.0f;
    for(;;)
    {
        if(k_2 < _S1210)
        {
        }
        else
        {
            break;
        }
        var total_1 : f32 = total_0 + face_solid_angle_0(record_10, word_0(_S1211 + k_2), from_1.exact_0);
        k_2 = k_2 + u32(1);
        total_0 = total_1;
    }
    var _S1212 : f32 = u_3 * total_0;
    var face_5 : u32 = u32(4294967295);
    var angle_5 : f32 = 0.0f;
    var inside_2 : f32 = 0.0f;
    k_2 = first_2;
    var rest_3 : f32 = _S1212;
    for(;;)
    {
        if(k_2 < _S1210)
        {
        }
        else
        {
            break;
        }
        var _S1213 : u32 = _S1211 + k_2;
        var own_1 : f32 = face_solid_angle_0(record_10, word_0(_S1213), from_1.exact_0);
        if(!(own_1 > 0.0f))
        {
            k_2 = k_2 + u32(1);
            continue;
        }
        var _S1214 : u32 = word_0(_S1213);
        var _S1215 : f32 = min(rest_3 / own_1, 1.0f);
        if(rest_3 < own_1)
        {
            face_5 = _S1214;
            angle_5 = own_1;
            inside_2 = _S1215;
            break;
        }
        var rest_4 : f32 = rest_3 - own_1;
        face_5 = _S1214;
        angle_5 = own_1;
        inside_2 = _S1215;
        rest_3 = rest_4;
        k_2 = k_2 + u32(1);
    }
    if(face_5 == u32(4294967295))
    {
        return point_0;
    }
    var corners_2 : Corners_0 = corners_from_0(record_10, face_5, from_1.exact_0);
    var ab_1 : vec3<f32> = corners_2.b_13 - corners_2.a_16;
    var ac_0 : vec3<f32> = corners_2.c_5 - corners_2.a_16;
    var normal_6 : vec3<f32> = cross(ab_1, ac_0);
    point_0.place_13.triangle_0 = emitter_triangle_0(record_10, face_5);
    if(angle_5 < 0.00100000004749745f)
    {
        var root_0 : f32 = sqrt(inside_2);
        point_0.place_13.v_0 = root_0 * (1.0f - second_1);
        point_0.place_13.w_0 = root_0 * second_1;
    }
    else
    {
        var direction_6 : vec3<f32> = triangle_direction_0(corners_2.a_16, corners_2.b_13, corners_2.c_5, angle_5, vec2<f32>(inside_2, second_1));
        var within_0 : vec3<f32> = direction_6 * vec3<f32>((dot(corners_2.a_16, normal_6) / dot(direction_6, normal_6))) - corners_2.a_16;
        var squared_4 : f32 = dot(normal_6, normal_6);
        var _S1216 : f32 = clamp(dot(cross(within_0, ac_0), normal_6) / squared_4, 0.0f, 1.0f);
        point_0.place_13.v_0 = _S1216;
        point_0.place_13.w_0 = clamp(dot(cross(ab_1, within_0), normal_6) / squared_4, 0.0f, 1.0f - _S1216);
    }
    var offset_3 : vec3<f32> = corners_2.a_16 + ab_1 * vec3<f32>(point_0.place_13.v_0) + ac_0 * vec3<f32>(point_0.place_13.w_0);
    var distance_5 : f32 = length(offset_3);
    if(!(distance_5 > 0.0f))
    {
        return point_0;
    }
    point_0.pdf_2 = chosen_0 / total_0 * density_of_0(angle_5, normal_6, distance_5, offset_3 / vec3<f32>(distance_5));
    return point_0;
}

fn is_map_0( record_11 : u32) -> bool
{
    return (word_0(record_11)) == u32(2);
}

fn uniform_direction_0( u_4 : vec2<f32>) -> vec3<f32>
{
    var _S1217 : f32 = u_4.x;
    var turn_1 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_4.y) * vec2<f32>((2.0f * sqrt(_S1217 * (1.0f - _S1217))));
    return vec3<f32>(turn_1.y, turn_1.x, 1.0f - 2.0f * _S1217);
}

fn map_place_0( map_1 : u32,  direction_7 : vec3<f32>) -> vec2<f32>
{
    var _S1218 : u32 = map_1 + u32(2);
    var d_3 : vec3<f32> = vector_at_0(_S1218) * vec3<f32>(direction_7.x) + vector_at_0(_S1218 + u32(3)) * vec3<f32>(direction_7.y) + vector_at_0(_S1218 + u32(6)) * vec3<f32>(direction_7.z);
    return vec2<f32>(angle_of_0(- d_3.z, d_3.x) * 0.15915493667125702f * f32(word_0(map_1)) - 0.5f, angle_of_0(d_3.y, length(d_3.xz)) * 0.31830987334251404f * (f32(word_0(map_1 + u32(1))) - 1.0f));
}

fn cell_pdf_0( map_2 : u32,  cell_0 : u32) -> f32
{
    return 0.00397887360304594f + 0.94999998807907104f * number_0(word_0(map_2 + u32(15)) + cell_0);
}

fn map_pdf_0( map_3 : u32,  direction_8 : vec3<f32>) -> f32
{
    if((word_0(map_3 + u32(13))) == u32(4294967295))
    {
        return 0.07957746833562851f;
    }
    var place_14 : vec2<f32> = map_place_0(map_3, direction_8);
    var width_2 : u32 = word_0(map_3);
    var column_0 : u32 = wrapped_0(floor_of_0(place_14.x), i32(width_2), u32(0));
    return cell_pdf_0(map_3, u32(clamp(floor_of_0(place_14.y), i32(0), i32(word_0(map_3 + u32(1))) - i32(2))) * width_2 + column_0);
}

fn chosen_interval_0( sums_1 : u32,  count_3 : u32,  u_5 : f32,  through_0 : ptr<function, f32>) -> u32
{
    var _S1219 : u32 = count_3 - u32(1);
    var total_2 : f32 = precise_0(sums_1 + u32(2) * _S1219);
    var target_0 : f32 = u_5 * total_2;
    var low_3 : u32 = u32(0);
    var high_0 : u32 = _S1219;
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
        var sum_4 : f32 = precise_0(sums_1 + u32(2) * middle_1);
        var _S1220 : bool;
        if(sum_4 <= target_0)
        {
            _S1220 = sum_4 < total_2;
        }
        else
        {
            _S1220 = false;
        }
        if(_S1220)
        {
            low_3 = middle_1 + u32(1);
        }
        else
        {
            high_0 = middle_1;
        }
    }
    var below_3 : f32;
    if(low_3 > u32(0))
    {
        below_3 = precise_0(sums_1 + u32(2) * (low_3 - u32(1)));
    }
    else
    {
        below_3 = 0.0f;
    }
    (*through_0) = clamp((target_0 - below_3) / (precise_0(sums_1 + u32(2) * low_3) - below_3), 0.0f, 1.0f);
    return low_3;
}

fn cell_direction_0( map_4 : u32,  column_1 : u32,  row_2 : u32,  along_1 : f32,  down_0 : f32) -> vec3<f32>
{
    var turns_0 : f32 = (f32(column_1) + 0.5f + along_1) / f32(word_0(map_4));
    var azimuth_0 : vec2<f32> = sine_cosine_0(6.28318548202514648f * (turns_0 - floor(turns_0 + 0.5f)));
    var last_0 : u32 = word_0(map_4 + u32(1)) - u32(1);
    var is_lower_0 : bool = (u32(2) * row_2) >= last_0;
    var rows_0 : vec2<f32>;
    if(is_lower_0)
    {
        var _S1221 : u32 = last_0 - row_2;
        rows_0 = vec2<f32>(f32(_S1221), f32(_S1221 - u32(1)));
    }
    else
    {
        rows_0 = vec2<f32>(f32(row_2), f32(row_2 + u32(1)));
    }
    var _S1222 : f32 = f32(last_0);
    var _S1223 : f32 = sine_cosine_0(rows_0.x * (1.57079637050628662f / _S1222)).x;
    var _S1224 : f32 = sine_cosine_0(rows_0.y * (1.57079637050628662f / _S1222)).x;
    var off_0 : f32 = 2.0f * mix(_S1223 * _S1223, _S1224 * _S1224, down_0);
    var sine_3 : f32 = sqrt(off_0 * (2.0f - off_0));
    var _S1225 : f32 = azimuth_0.x * sine_3;
    var _S1226 : f32;
    if(is_lower_0)
    {
        _S1226 = off_0 - 1.0f;
    }
    else
    {
        _S1226 = 1.0f - off_0;
    }
    var local_0 : vec3<f32> = vec3<f32>(_S1225, _S1226, - azimuth_0.y * sine_3);
    var _S1227 : u32 = map_4 + u32(2);
    return vec3<f32>(dot(vector_at_0(_S1227), local_0), dot(vector_at_0(_S1227 + u32(3)), local_0), dot(vector_at_0(_S1227 + u32(6)), local_0));
}

fn sample_map_0( map_5 : u32,  key_5 : vec2<u32>,  dimension_4 : u32,  pdf_3 : ptr<function, f32>) -> vec3<f32>
{
    var u_6 : f32 = precise_random_0(key_5, dimension_4);
    var rest_5 : f32 = u_6 * 20.0f - 1.0f;
    var _S1228 : u32 = map_5 + u32(13);
    var is_black_1 : bool = (word_0(_S1228)) == u32(4294967295);
    var _S1229 : bool;
    if(is_black_1)
    {
        _S1229 = true;
    }
    else
    {
        _S1229 = rest_5 < 0.0f;
    }
    if(_S1229)
    {
        var share_0 : f32;
        if(is_black_1)
        {
            share_0 = 1.0f;
        }
        else
        {
            share_0 = 0.05000000074505806f;
        }
        var direction_9 : vec3<f32> = uniform_direction_0(vec2<f32>(u_6 / share_0, random_0(key_5, dimension_4 + u32(1))));
        var _S1230 : f32 = map_pdf_0(map_5, direction_9);
        (*pdf_3) = _S1230;
        return direction_9;
    }
    var rest_6 : f32 = rest_5 / 19.0f;
    var width_3 : u32 = word_0(map_5);
    var down_1 : f32;
    var row_3 : u32 = chosen_interval_0(word_0(_S1228), word_0(map_5 + u32(1)) - u32(1), precise_random_0(key_5, dimension_4 + u32(1)), &(down_1));
    var along_2 : f32;
    var column_2 : u32 = chosen_interval_0(word_0(map_5 + u32(14)) + u32(2) * width_3 * row_3, width_3, rest_6, &(along_2));
    (*pdf_3) = cell_pdf_0(map_5, row_3 * width_3 + column_2);
    return cell_direction_0(map_5, column_2, row_3, along_2, down_1);
}

fn random_pair_0( key_6 : vec2<u32>,  dimension_5 : u32) -> vec2<f32>
{
    return vec2<f32>(random_0(key_6, dimension_5), random_0(key_6, dimension_5 + u32(1)));
}

fn sample_cosine_0( u_7 : vec2<f32>) -> vec3<f32>
{
    var _S1231 : f32 = u_7.x;
    var turn_2 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_7.y) * vec2<f32>(sqrt(_S1231));
    return vec3<f32>(turn_2.y, turn_2.x, sqrt(1.0f - _S1231));
}

fn to_world_0( axes_6 : Axes_0,  v_7 : vec3<f32>) -> vec3<f32>
{
    return axes_6.s_0 * vec3<f32>(v_7.x) + axes_6.t_0 * vec3<f32>(v_7.y) + axes_6.n_0 * vec3<f32>(v_7.z);
}

struct LightSample_0
{
     direction_10 : vec3<f32>,
     wo_1 : vec3<f32>,
     way_1 : vec3<f32>,
     nearest_0 : f32,
     farthest_0 : f32,
     is_on_emitter_0 : bool,
     emitter_5 : u32,
     probability_3 : f32,
     pdf_4 : f32,
     distance_6 : f32,
     place_15 : Place_0,
     is_specular_1 : bool,
};

fn sample_emitter_0( vertex_1 : Vertex_0,  choice_5 : Choice_0,  key_7 : vec2<u32>,  first_3 : u32,  sample_0 : ptr<function, LightSample_0>) -> bool
{
    (*sample_0).is_on_emitter_0 = true;
    (*sample_0).is_specular_1 = false;
    (*sample_0).direction_10 = vertex_1.axes_4.n_0;
    (*sample_0).wo_1 = vec3<f32>(0.0f);
    (*sample_0).way_1 = vertex_1.surface_3.exact_0;
    (*sample_0).distance_6 = 0.0f;
    (*sample_0).pdf_4 = 0.0f;
    (*sample_0).place_15 = vertex_1.surface_3.place_5;
    (*sample_0).nearest_0 = limit_at_0(u32(2));
    (*sample_0).farthest_0 = limit_at_0(u32(1));
    var _S1232 : f32 = random_0(key_7, first_3);
    var _S1233 : f32 = (*sample_0).probability_3;
    var _S1234 : u32 = chosen_emitter_0(choice_5, _S1232, &(_S1233));
    (*sample_0).probability_3 = _S1233;
    (*sample_0).emitter_5 = _S1234;
    if(_S1233 == 0.0f)
    {
        return false;
    }
    var record_12 : u32 = emitter_record_0((*sample_0).emitter_5);
    if(is_area_0(record_12))
    {
        var point_1 : EmitterPoint_0 = area_point_0(record_12, vertex_1.surface_3, key_7, first_3 + u32(1));
        if(!((point_1.pdf_2) > 0.0f))
        {
            return false;
        }
        (*sample_0).pdf_4 = point_1.pdf_2;
        (*sample_0).place_15 = point_1.place_13;
        var _S1235 : vec3<f32> = position_of_0(point_1.place_13) - vertex_1.surface_3.exact_0;
        (*sample_0).way_1 = _S1235;
        var _S1236 : f32 = length(_S1235);
        (*sample_0).distance_6 = _S1236;
        (*sample_0).direction_10 = _S1235 / vec3<f32>(_S1236);
        (*sample_0).nearest_0 = (*sample_0).nearest_0 / _S1236;
        (*sample_0).farthest_0 = limit_at_0(u32(3));
    }
    else
    {
        if(is_map_0(record_12))
        {
            var _S1237 : u32 = word_0(record_12 + u32(1));
            var _S1238 : u32 = first_3 + u32(1);
            var _S1239 : f32 = (*sample_0).pdf_4;
            var _S1240 : vec3<f32> = sample_map_0(_S1237, key_7, _S1238, &(_S1239));
            (*sample_0).pdf_4 = _S1239;
            (*sample_0).direction_10 = _S1240;
        }
        else
        {
            var local_1 : vec3<f32> = sample_cosine_0(random_pair_0(key_7, first_3 + u32(1)));
            (*sample_0).direction_10 = normalize(to_world_0(vertex_1.axes_4, local_1));
            (*sample_0).pdf_4 = local_1.z * 0.31830987334251404f;
        }
        (*sample_0).way_1 = (*sample_0).direction_10;
    }
    var _S1241 : vec3<f32> = to_local_0(vertex_1.axes_4, (*sample_0).direction_10);
    (*sample_0).wo_1 = _S1241;
    return (_S1241.z) > 0.0f;
}

fn first_material_number_0( depth_2 : u32) -> u32
{
    return vertex_numbers_0(depth_2) + u32(3) * word_0(u32(2));
}

fn coat_eta_0( numbers_5 : Numbers_0) -> f32
{
    return luminance_0(numbers_5.eta_0) / luminance_0(numbers_5.k_0);
}

fn fresnel_dielectric_0( cosine_5 : f32,  eta_1 : f32) -> f32
{
    var eta2_2 : f32 = eta_1 * eta_1;
    var cos2_6 : f32 = cosine_5 * cosine_5;
    var denser_2 : f32 = (eta_1 - 1.0f) * (eta_1 + 1.0f);
    var squared_5 : f32 = denser_2 + cos2_6;
    if(squared_5 <= 0.0f)
    {
        return 1.0f;
    }
    var refracted_0 : f32 = sqrt(squared_5);
    var s_sum_2 : f32 = cosine_5 + refracted_0;
    var p_sum_4 : f32 = eta2_2 * cosine_5 + refracted_0;
    var senkrecht_3 : f32 = denser_2 / (s_sum_2 * s_sum_2);
    var parallel_1 : f32 = denser_2 * ((eta2_2 + 1.0f) * cos2_6 - 1.0f) / (p_sum_4 * p_sum_4);
    return 0.5f * (senkrecht_3 * senkrecht_3 + parallel_1 * parallel_1);
}

fn transmittance_0( lobe_8 : Lobe_0,  eta_2 : f32,  cosine_6 : f32) -> f32
{
    if((lobe_8.kind_0) == u32(3))
    {
        return 1.0f - fresnel_dielectric_0(cosine_6, eta_2);
    }
    var place_16 : f32 = cosine_6 * 63.0f;
    var _S1242 : u32 = min(u32(place_16), u32(62));
    var at_16 : u32 = word_0(lobe_8.record_0 + u32(3)) + _S1242;
    var here_1 : f32 = number_0(at_16);
    return here_1 + (number_0(at_16 + u32(1)) - here_1) * (place_16 - f32(_S1242));
}

fn facets_of_0( lobe_9 : Lobe_0,  numbers_6 : Numbers_0) -> Microfacets_0
{
    var facets_0 : Microfacets_0;
    facets_0.distribution_1 = lobe_9.distribution_0;
    facets_0.alpha_1 = max(numbers_6.alpha_0, vec2<f32>(0.00009999999747379f));
    return facets_0;
}

struct Stretched_0
{
     sine_4 : f32,
     cosine_7 : f32,
     around_0 : vec2<f32>,
     length_0 : f32,
};

fn stretched_2( facets_1 : Microfacets_0,  wi_3 : vec3<f32>) -> Stretched_0
{
    var longer_0 : vec3<f32> = vec3<f32>(wi_3.xy * facets_1.alpha_1, wi_3.z);
    var view_2 : Stretched_0;
    var _S1243 : f32 = length(longer_0);
    view_2.length_0 = _S1243;
    var longer_1 : vec3<f32> = longer_0 / vec3<f32>(_S1243);
    var _S1244 : vec2<f32> = longer_1.xy;
    var _S1245 : f32 = length(_S1244);
    view_2.sine_4 = _S1245;
    view_2.cosine_7 = longer_1.z;
    var _S1246 : vec2<f32>;
    if(_S1245 > 0.0f)
    {
        _S1246 = _S1244 / vec2<f32>(view_2.sine_4);
    }
    else
    {
        _S1246 = vec2<f32>(1.0f, 0.0f);
    }
    view_2.around_0 = _S1246;
    return view_2;
}

fn ggx_normal_0( view_3 : Stretched_0,  u_8 : vec2<f32>) -> vec3<f32>
{
    var _S1247 : f32 = u_8.x;
    var radius_2 : f32 = sqrt(_S1247);
    var turn_3 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_8.y);
    var across_1 : f32 = radius_2 * turn_3.y;
    var along_3 : f32 = radius_2 * turn_3.x;
    var visible_0 : f32 = 0.5f * (1.0f + view_3.cosine_7);
    var hidden_0 : f32 = 1.0f - visible_0;
    var _S1248 : f32 = 1.0f - _S1247;
    var edge_0 : f32 = sqrt(_S1248 + along_3 * along_3);
    var up_0 : f32 = hidden_0 * edge_0 + visible_0 * along_3;
    var from_top_0 : f32 = edge_0 - along_3;
    var from_bottom_0 : f32 = edge_0 + along_3;
    var from_top_1 : f32;
    var from_bottom_1 : f32;
    if(along_3 > 0.0f)
    {
        from_top_1 = _S1248 / from_bottom_0;
        from_bottom_1 = from_bottom_0;
    }
    else
    {
        var _S1249 : f32 = _S1248 / from_top_0;
        from_top_1 = from_top_0;
        from_bottom_1 = _S1249;
    }
    var towards_0 : f32 = sqrt(visible_0 * from_top_1 * (2.0f * hidden_0 * edge_0 + visible_0 * from_bottom_1));
    return vec3<f32>(towards_0 * view_3.sine_4 - up_0 * view_3.cosine_7, across_1, max(towards_0 * view_3.cosine_7 + up_0 * view_3.sine_4, 0.0f));
}

fn visible_over_cos_0( facets_2 : Microfacets_0,  w_4 : vec3<f32>) -> f32
{
    var stretched_3 : vec2<f32> = w_4.xy * facets_2.alpha_1;
    var spread2_0 : f32 = dot(stretched_3, stretched_3);
    var _S1250 : f32 = w_4.z;
    var z2_3 : f32 = _S1250 * _S1250;
    if((facets_2.distribution_1) == u32(1))
    {
        return 2.0f / (_S1250 + sqrt(z2_3 + spread2_0));
    }
    if(z2_3 >= (36.0f * spread2_0))
    {
        return 1.0f / _S1250;
    }
    var spread_0 : f32 = sqrt(spread2_0);
    var both_0 : vec2<f32> = error_function_plus_one_0(_S1250 / spread_0);
    return 2.0f / (_S1250 * both_0.x + 0.5f * spread_0 * both_0.y);
}

fn logarithm_0( x_22 : f32) -> f32
{
    var bits_0 : u32 = (bitcast<u32>((x_22)));
    var power_3 : f32 = f32(i32((bits_0 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((bits_0 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var power_4 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var power_5 : f32 = power_3 - 1.0f;
        m_1 = m_0 + m_0;
        power_4 = power_5;
    }
    else
    {
        m_1 = m_0;
        power_4 = power_3;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var z_5 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * z_5 - 0.00021219444170129f * power_4 - 0.5f * z_5) + 0.693359375f * power_4;
}

fn error_function_inverse_0( p_0 : f32) -> f32
{
    var w_5 : f32 = - logarithm_0((1.0f - p_0) * (1.0f + p_0));
    if(w_5 < 5.0f)
    {
        var w_6 : f32 = w_5 - 2.5f;
        return ((((((((2.81022636272609816e-08f * w_6 + 3.43273939051869093e-07f) * w_6 - 3.52338770426285919e-06f) * w_6 - 4.39150653619435616e-06f) * w_6 + 0.00021858086984139f) * w_6 - 0.00125372502952814f) * w_6 - 0.00417768163606524f) * w_6 + 0.24664072692394257f) * w_6 + 1.50140941143035889f) * p_0;
    }
    var w_7 : f32 = sqrt(w_5) - 3.0f;
    return ((((((((-0.0002002142573474f * w_7 + 0.00010095055768033f) * w_7 + 0.00134934321977198f) * w_7 - 0.00367342843674123f) * w_7 + 0.00573950773105025f) * w_7 - 0.00762246130034328f) * w_7 + 0.00943887047469616f) * w_7 + 1.00167405605316162f) * w_7 + 2.8329768180847168f) * p_0;
}

fn beckmann_normal_0( view_4 : Stretched_0,  visible_1 : f32,  u_9 : vec2<f32>) -> vec3<f32>
{
    var steepest_0 : f32;
    if((view_4.sine_4 * 6.0f) > (view_4.cosine_7))
    {
        steepest_0 = view_4.cosine_7 / view_4.sine_4;
    }
    else
    {
        steepest_0 = 6.0f;
    }
    var target_1 : f32 = u_9.x * (2.0f / (visible_1 * view_4.length_0));
    var _S1251 : f32 = max(view_4.cosine_7, view_4.sine_4);
    var slope_3 : f32 = clamp(error_function_inverse_0(clamp(target_1 / _S1251 - 1.0f, -0.99999994039535522f, 0.99999994039535522f)) + -0.5f * view_4.sine_4 / _S1251, -6.0f, 0.5f * steepest_0);
    var low_4 : f32 = -6.0f;
    var high_1 : f32 = steepest_0;
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
        var both_1 : vec2<f32> = error_function_plus_one_0(slope_3);
        var _S1252 : f32 = both_1.y;
        var error_0 : f32 = view_4.cosine_7 * both_1.x + 0.5f * view_4.sine_4 * _S1252 - target_1;
        var own_2 : f32 = _S1252 * (view_4.cosine_7 - slope_3 * view_4.sine_4);
        var bend_0 : f32 = -2.0f * slope_3 * own_2 - _S1252 * view_4.sine_4;
        if(error_0 > 0.0f)
        {
            high_1 = slope_3;
        }
        else
        {
            low_4 = slope_3;
        }
        var next_1 : f32 = slope_3 - error_0 * own_2 / (own_2 * own_2 - 0.5f * error_0 * bend_0);
        var _S1253 : bool;
        if(next_1 >= low_4)
        {
            _S1253 = next_1 <= high_1;
        }
        else
        {
            _S1253 = false;
        }
        var next_2 : f32;
        if(!_S1253)
        {
            next_2 = 0.5f * (low_4 + high_1);
        }
        else
        {
            next_2 = next_1;
        }
        if((abs(next_2 - slope_3)) < 0.00030000001424924f)
        {
            slope_3 = next_2;
            break;
        }
        var _S1254 : u32 = step_0 + u32(1);
        slope_3 = next_2;
        step_0 = _S1254;
    }
    return vec3<f32>(- slope_3, error_function_inverse_0(max(2.0f * u_9.y - 1.0f, -0.99999994039535522f)), 1.0f);
}

fn mirrored_at_facet_0( facets_3 : Microfacets_0,  wi_4 : vec3<f32>,  u_10 : vec2<f32>) -> vec3<f32>
{
    var view_5 : Stretched_0 = stretched_2(facets_3, wi_4);
    var normal_7 : vec3<f32>;
    if((facets_3.distribution_1) == u32(1))
    {
        normal_7 = ggx_normal_0(view_5, u_10);
    }
    else
    {
        normal_7 = beckmann_normal_0(view_5, visible_over_cos_0(facets_3, wi_4), u_10);
    }
    var _S1255 : f32 = view_5.around_0.x;
    var _S1256 : f32 = normal_7.x;
    var _S1257 : f32 = view_5.around_0.y;
    var _S1258 : f32 = normal_7.y;
    var normal_8 : vec3<f32> = normalize(vec3<f32>(vec2<f32>(_S1255 * _S1256 - _S1257 * _S1258, _S1257 * _S1256 + _S1255 * _S1258) * facets_3.alpha_1, normal_7.z));
    return normalize(normal_8 * vec3<f32>((2.0f * dot(wi_4, normal_8))) - wi_4);
}

struct Drawn_0
{
     wo_2 : vec3<f32>,
     is_specular_2 : bool,
     probability_4 : f32,
};

fn draw_0( lobe_10 : Lobe_0,  wi_5 : vec3<f32>,  choice_6 : f32,  u_11 : vec2<f32>) -> Drawn_0
{
    var _S1259 : bool = (lobe_10.kind_0) == u32(0);
    var has_base_0 : bool;
    if(_S1259)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_10.kind_0) == u32(3);
    }
    if(has_base_0)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_10.kind_0) == u32(4);
    }
    var of_base_1 : f32;
    if(_S1259)
    {
        of_base_1 = 1.0f;
    }
    else
    {
        of_base_1 = 0.0f;
    }
    var _S1260 : bool;
    if((lobe_10.kind_0) == u32(3))
    {
        _S1260 = true;
    }
    else
    {
        _S1260 = (lobe_10.kind_0) == u32(4);
    }
    if(_S1260)
    {
        of_base_1 = base_probability_0(lobe_10.numbers_0, transmittance_0(lobe_10, coat_eta_0(lobe_10.numbers_0), wi_5.z));
    }
    var drawn_0 : Drawn_0;
    drawn_0.is_specular_2 = false;
    drawn_0.probability_4 = 1.0f;
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
        drawn_0.wo_2 = sample_cosine_0(u_11);
    }
    else
    {
        if(is_rough_0(lobe_10))
        {
            drawn_0.wo_2 = mirrored_at_facet_0(facets_of_0(lobe_10, lobe_10.numbers_0), wi_5, u_11);
        }
        else
        {
            drawn_0.wo_2 = vec3<f32>((vec2<f32>(0) - wi_5.xy), wi_5.z);
            drawn_0.is_specular_2 = true;
            drawn_0.probability_4 = 1.0f - of_base_1;
        }
    }
    return drawn_0;
}

fn sample_material_0( vertex_2 : Vertex_0,  key_8 : vec2<u32>,  first_4 : u32) -> LightSample_0
{
    var drawn_1 : Drawn_0 = draw_0(vertex_2.lobe_6, value_of_0(vertex_2.wi_1), random_0(key_8, first_4), random_pair_0(key_8, first_4 + u32(1)));
    var sample_1 : LightSample_0;
    sample_1.is_on_emitter_0 = false;
    sample_1.is_specular_1 = drawn_1.is_specular_2;
    sample_1.probability_3 = drawn_1.probability_4;
    sample_1.wo_1 = drawn_1.wo_2;
    var _S1261 : vec3<f32> = normalize(to_world_0(vertex_2.axes_4, drawn_1.wo_2));
    sample_1.direction_10 = _S1261;
    sample_1.way_1 = _S1261;
    sample_1.nearest_0 = limit_at_0(u32(2));
    sample_1.farthest_0 = limit_at_0(u32(1));
    sample_1.emitter_5 = u32(4294967295);
    sample_1.distance_6 = 0.0f;
    sample_1.pdf_4 = 0.0f;
    sample_1.place_15 = vertex_2.surface_3.place_5;
    return sample_1;
}

fn walked_of_0( path_6 : Path_0) -> vec3<f32>
{
    return vec3<f32>(0.0f);
}

fn specular_direction_0( vertex_3 : Vertex_0,  direction_11 : vec3<f32>,  wo_3 : vec3<f32>) -> vec3<f32>
{
    return direction_11;
}

fn fresnel_conductor_channel_0( cosine_8 : f32,  eta_3 : f32,  k_3 : f32) -> f32
{
    var cos2_7 : f32 = cosine_8 * cosine_8;
    var sin2_2 : f32 = 1.0f - cos2_7;
    var real_2 : f32 = eta_3 * eta_3 - k_3 * k_3 - sin2_2;
    var product_3 : f32 = eta_3 * k_3;
    var modulus_0 : f32 = sqrt(real_2 * real_2 + 4.0f * (product_3 * product_3));
    if(modulus_0 == 0.0f)
    {
        return 1.0f;
    }
    var larger_0 : f32 = sqrt(0.5f * (modulus_0 + abs(real_2)));
    var smaller_2 : f32 = product_3 / larger_0;
    var _S1262 : bool = real_2 < 0.0f;
    var a_18 : f32;
    if(_S1262)
    {
        a_18 = smaller_2;
    }
    else
    {
        a_18 = larger_0;
    }
    var b_15 : f32;
    if(_S1262)
    {
        b_15 = larger_0;
    }
    else
    {
        b_15 = smaller_2;
    }
    var less_2 : f32 = a_18 - cosine_8;
    var more_2 : f32 = a_18 + cosine_8;
    var _S1263 : f32 = b_15 * b_15;
    var p_sum_5 : f32 = modulus_0 * cos2_7 + sin2_2 * sin2_2;
    return (less_2 * less_2 + _S1263) / (more_2 * more_2 + _S1263) * p_sum_5 / (p_sum_5 + 2.0f * a_18 * cosine_8 * sin2_2);
}

fn fresnel_conductor_0( cosine_9 : f32,  eta_4 : vec3<f32>,  k_4 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(fresnel_conductor_channel_0(cosine_9, eta_4.x, k_4.x), fresnel_conductor_channel_0(cosine_9, eta_4.y, k_4.y), fresnel_conductor_channel_0(cosine_9, eta_4.z, k_4.z));
}

fn specular_fraction_0( lobe_11 : Lobe_0,  numbers_7 : Numbers_0,  wi_6 : vec3<f32>) -> vec3<f32>
{
    if((lobe_11.kind_0) == u32(1))
    {
        return numbers_7.specular_reflectance_0 * fresnel_conductor_0(wi_6.z, numbers_7.eta_0, numbers_7.k_0);
    }
    return numbers_7.specular_reflectance_0 * vec3<f32>(fresnel_dielectric_0(wi_6.z, coat_eta_0(numbers_7)));
}

fn specular_0( lobe_12 : Lobe_0,  wi_7 : vec3<f32>) -> vec3<f32>
{
    return specular_fraction_0(lobe_12, lobe_12.numbers_0, wi_7);
}

fn turning_0( vertex_4 : Vertex_0,  direction_12 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(0.0f);
}

fn towards_emitter_0( vertex_5 : Vertex_0,  direction_13 : vec3<f32>,  record_13 : u32) -> vec3<f32>
{
    var _S1264 : vec3<f32>;
    if((word_0(record_13)) == u32(1))
    {
        _S1264 = changing_0(direction_13, turning_0(vertex_5, direction_13));
    }
    else
    {
        _S1264 = still_0(direction_13);
    }
    return _S1264;
}

fn change_word_0( at_17 : u32) -> u32
{
    return input_0[launch_0.room_0 + at_17];
}

fn walks_0() -> bool
{
    return (change_word_0(u32(6))) != u32(0);
}

fn turns_onward_0() -> bool
{
    return !walks_0();
}

fn local_change_0( vertex_6 : Vertex_0,  direction_14 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(0.0f);
}

fn Mirrored_x24init_0( cosine_10 : f32,  pdf_5 : f32,  scattered_1 : f32) -> Mirrored_0
{
    var _S1265 : Mirrored_0;
    _S1265.cosine_0 = cosine_10;
    _S1265.pdf_1 = pdf_5;
    _S1265.scattered_0 = scattered_1;
    return _S1265;
}

fn density_0( facets_4 : Microfacets_0,  m_3 : vec3<f32>) -> f32
{
    var _S1266 : f32 = m_3.z;
    if(_S1266 <= 0.0f)
    {
        return 0.0f;
    }
    var scale_2 : f32 = 3.14159274101257324f * facets_4.alpha_1.x * facets_4.alpha_1.y;
    var slope_4 : vec2<f32> = m_3.xy / facets_4.alpha_1;
    var spread_1 : f32 = dot(slope_4, slope_4);
    var cos2_8 : f32 = _S1266 * _S1266;
    if((facets_4.distribution_1) == u32(1))
    {
        var sum_5 : f32 = spread_1 + cos2_8;
        return 1.0f / (scale_2 * sum_5 * sum_5);
    }
    var exponent_2 : f32 = spread_1 / cos2_8;
    var _S1267 : f32;
    if(exponent_2 > 80.0f)
    {
        _S1267 = 0.0f;
    }
    else
    {
        _S1267 = exponential_0(- exponent_2) / (scale_2 * cos2_8 * cos2_8);
    }
    return _S1267;
}

fn mirrored_0( facets_5 : Microfacets_0,  wi_8 : vec3<f32>,  wo_4 : vec3<f32>) -> Mirrored_0
{
    var h_1 : vec3<f32> = normalize(wi_8 + wo_4);
    var mirrored_1 : Mirrored_0;
    mirrored_1.cosine_0 = dot(wi_8, h_1);
    var _S1268 : f32 = 0.25f * density_0(facets_5, h_1) * visible_over_cos_0(facets_5, wi_8);
    mirrored_1.pdf_1 = _S1268;
    mirrored_1.scattered_0 = _S1268 * visible_over_cos_0(facets_5, wo_4) * wo_4.z;
    return mirrored_1;
}

fn fresnel_diffuse_0( eta_5 : f32) -> f32
{
    var inverse_2 : f32 = 1.0f / eta_5;
    if(eta_5 < 1.0f)
    {
        return (-1.43990004062652588f * eta_5 + 0.70990002155303955f) * eta_5 + 0.66809999942779541f + 0.06360000371932983f * inverse_2;
    }
    return ((((-1.36881005764007568f * inverse_2 + 4.98553991317749023f) * inverse_2 - 7.80988979339599609f) * inverse_2 + 6.75334978103637695f) * inverse_2 - 3.47930002212524414f) * inverse_2 + 0.91931700706481934f;
}

fn base_0( lobe_13 : Lobe_0,  eta_6 : f32,  diffuse_0 : vec3<f32>) -> vec3<f32>
{
    var internal_reflectance_2 : f32;
    if((lobe_13.kind_0) == u32(3))
    {
        internal_reflectance_2 = fresnel_diffuse_0(1.0f / eta_6);
    }
    else
    {
        internal_reflectance_2 = number_0(word_0(lobe_13.record_0 + u32(3)) + u32(64));
    }
    if((word_0(lobe_13.record_0 + u32(2))) == u32(0))
    {
        return diffuse_0 * vec3<f32>((1.0f / (1.0f - internal_reflectance_2)));
    }
    return diffuse_0 / (vec3<f32>(1.0f) - diffuse_0 * vec3<f32>(internal_reflectance_2));
}

fn scattering_1( lobe_14 : Lobe_0,  numbers_8 : Numbers_0,  wi_9 : vec3<f32>,  wo_5 : vec3<f32>) -> Scattering_0
{
    var scattering_2 : Scattering_0;
    var _S1269 : f32 = wo_5.z;
    var by_cosine_2 : f32 = _S1269 * 0.31830987334251404f;
    if((lobe_14.kind_0) == u32(0))
    {
        scattering_2.value_1 = numbers_8.diffuse_reflectance_0 * vec3<f32>(by_cosine_2);
        scattering_2.pdf_0 = by_cosine_2;
        return scattering_2;
    }
    var _S1270 : Mirrored_0 = Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
    var by_facets_2 : Mirrored_0;
    if(is_rough_0(lobe_14))
    {
        by_facets_2 = mirrored_0(facets_of_0(lobe_14, numbers_8), wi_9, wo_5);
    }
    else
    {
        by_facets_2 = _S1270;
    }
    if((lobe_14.kind_0) == u32(2))
    {
        scattering_2.value_1 = numbers_8.specular_reflectance_0 * (fresnel_conductor_0(by_facets_2.cosine_0, numbers_8.eta_0, numbers_8.k_0) * vec3<f32>(by_facets_2.scattered_0));
        scattering_2.pdf_0 = by_facets_2.pdf_1;
        return scattering_2;
    }
    var eta_7 : f32 = coat_eta_0(numbers_8);
    var enters_1 : f32 = transmittance_0(lobe_14, eta_7, wi_9.z);
    scattering_2.value_1 = base_0(lobe_14, eta_7, numbers_8.diffuse_reflectance_0) * vec3<f32>((enters_1 * transmittance_0(lobe_14, eta_7, _S1269) * by_cosine_2 / (eta_7 * eta_7)));
    var probability_5 : f32 = base_probability_0(numbers_8, enters_1);
    scattering_2.pdf_0 = probability_5 * by_cosine_2;
    if((lobe_14.kind_0) == u32(4))
    {
        scattering_2.value_1 = scattering_2.value_1 + numbers_8.specular_reflectance_0 * vec3<f32>((fresnel_dielectric_0(by_facets_2.cosine_0, eta_7) * by_facets_2.scattered_0));
        scattering_2.pdf_0 = scattering_2.pdf_0 + (1.0f - probability_5) * by_facets_2.pdf_1;
    }
    return scattering_2;
}

struct Scattered_0
{
     value_9 : vec3<f32>,
     pdf_6 : f32,
};

fn eval_and_pdf_0( lobe_15 : Lobe_0,  wi_10 : vec3<f32>,  wo_6 : vec3<f32>) -> Scattered_0
{
    var scattered_2 : Scattered_0;
    scattered_2.value_9 = still_0(vec3<f32>(0.0f));
    scattered_2.pdf_6 = 0.0f;
    var _S1271 : bool;
    if((value_of_0(wo_6).z) <= 0.0f)
    {
        _S1271 = true;
    }
    else
    {
        _S1271 = !has_smooth_0(lobe_15);
    }
    if(_S1271)
    {
        return scattered_2;
    }
    var both_2 : Scattering_0 = scattering_1(lobe_15, lobe_15.numbers_0, wi_10, wo_6);
    scattered_2.value_9 = both_2.value_1;
    scattered_2.pdf_6 = both_2.pdf_0;
    return scattered_2;
}

fn scattered_to_0( vertex_7 : Vertex_0,  wo_7 : vec3<f32>,  direction_15 : vec3<f32>) -> Scattered_0
{
    return eval_and_pdf_0(vertex_7.lobe_6, vertex_7.wi_1, changing_0(wo_7, local_change_0(vertex_7, direction_15)));
}

fn scattered_along_0( vertex_8 : Vertex_0,  sample_2 : LightSample_0,  walked_0 : vec3<f32>,  moving_0 : ptr<function, vec3<f32>>) -> Scattered_0
{
    if(sample_2.is_specular_1)
    {
        (*moving_0) = specular_direction_0(vertex_8, sample_2.direction_10, sample_2.wo_1);
        var scattered_3 : Scattered_0;
        scattered_3.value_9 = specular_0(vertex_8.lobe_6, vertex_8.wi_1);
        scattered_3.pdf_6 = sample_2.probability_3;
        return scattered_3;
    }
    if((sample_2.emitter_5) != u32(4294967295))
    {
        (*moving_0) = towards_emitter_0(vertex_8, sample_2.direction_10, emitter_record_0(sample_2.emitter_5));
    }
    else
    {
        var _S1272 : vec3<f32>;
        if(turns_onward_0())
        {
            _S1272 = turning_0(vertex_8, sample_2.direction_10);
        }
        else
        {
            _S1272 = walked_0;
        }
        (*moving_0) = changing_0(sample_2.direction_10, _S1272);
    }
    return scattered_to_0(vertex_8, sample_2.wo_1, (*moving_0));
}

fn component_0( v_8 : vec3<f32>,  axis_2 : u32) -> f32
{
    var _S1273 : f32;
    if(axis_2 == u32(0))
    {
        _S1273 = v_8.x;
    }
    else
    {
        if(axis_2 == u32(1))
        {
            _S1273 = v_8.y;
        }
        else
        {
            _S1273 = v_8.z;
        }
    }
    return _S1273;
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
     largest_0 : f32,
};

fn ray_along_0( origin_1 : vec3<f32>,  direction_16 : vec3<f32>,  t_min_1 : f32,  t_max_1 : f32,  axes_7 : ptr<function, u32>) -> Ray_0
{
    var size_2 : vec3<f32> = abs(direction_16);
    var _S1274 : f32 = size_2.x;
    var _S1275 : f32 = size_2.y;
    var _S1276 : bool;
    if(_S1274 >= _S1275)
    {
        _S1276 = _S1274 >= (size_2.z);
    }
    else
    {
        _S1276 = false;
    }
    var _S1277 : i32;
    if(_S1276)
    {
        _S1277 = i32(0);
    }
    else
    {
        if(_S1275 >= (size_2.z))
        {
            _S1277 = i32(1);
        }
        else
        {
            _S1277 = i32(2);
        }
    }
    var z_6 : u32 = u32(_S1277);
    var x_23 : u32 = (z_6 + u32(1)) % u32(3);
    var y_8 : u32 = (z_6 + u32(2)) % u32(3);
    (*axes_7) = (((x_23 | (((y_8 << (u32(2))))))) | (((z_6 << (u32(4))))));
    var ray_0 : Ray_0;
    ray_0.origin_0 = origin_1;
    var along_4 : f32 = component_0(direction_16, z_6);
    ray_0.inverse_z_0 = 1.0f / along_4;
    ray_0.shear_x_0 = component_0(direction_16, x_23) / along_4;
    ray_0.shear_y_0 = component_0(direction_16, y_8) / along_4;
    ray_0.t_min_0 = t_min_1;
    ray_0.t_max_0 = t_max_1;
    ray_0.local_per_t_0 = abs(along_4);
    ray_0.enter_0 = 0.0f;
    ray_0.edge_on_0 = limit_at_0(u32(0));
    ray_0.largest_0 = limit_at_0(u32(1));
    return ray_0;
}

fn ray_child_0( node_3 : u32,  slot_2 : u32) -> u32
{
    return nodes_0[u32(14) * node_3 + u32(12) + slot_2 / u32(4)][slot_2 % u32(4)];
}

struct RayView_0
{
     inverse_3 : vec3<f32>,
     offset_near_0 : vec3<f32>,
     offset_far_0 : vec3<f32>,
     limit_0 : f32,
     margin_0 : f32,
     axes_8 : u32,
};

fn ray_bound_0( view_6 : RayView_0,  limit_1 : f32,  node_4 : u32,  slot_3 : u32) -> f32
{
    var _S1278 : u32 = u32(14) * node_4 + slot_3 / u32(4);
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
        var _S1279 : u32 = axis_3;
        var _S1280 : u32 = _S1278 + u32(2) * axis_3;
        var _S1281 : u32 = slot_3 % u32(4);
        var low_5 : f32 = (bitcast<f32>((nodes_0[_S1280][_S1281])));
        var high_2 : f32 = (bitcast<f32>((nodes_0[_S1280 + u32(6)][_S1281])));
        var _S1282 : bool = (view_6.inverse_3[axis_3]) < 0.0f;
        var _S1283 : f32;
        if(_S1282)
        {
            _S1283 = high_2;
        }
        else
        {
            _S1283 = low_5;
        }
        var _S1284 : f32 = max(near_0, _S1283 * view_6.inverse_3[_S1279] - view_6.offset_near_0[axis_3]);
        var _S1285 : f32;
        if(_S1282)
        {
            _S1285 = low_5;
        }
        else
        {
            _S1285 = high_2;
        }
        var _S1286 : f32 = min(far_0, _S1285 * view_6.inverse_3[_S1279] - view_6.offset_far_0[axis_3]);
        var _S1287 : u32 = axis_3 + u32(1);
        near_0 = _S1284;
        far_0 = _S1286;
        axis_3 = _S1287;
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
    var k_5 : u32 = u32(0);
    var order_0 : u32 = u32(0);
    for(;;)
    {
        if(k_5 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S1288 : u32 = k_5;
        if((bounds_0[k_5]) > limit_2)
        {
            k_5 = k_5 + u32(1);
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
            var _S1289 : u32 = j_0;
            var _S1290 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S1288]))
            {
                _S1290 = true;
            }
            else
            {
                if((bounds_0[_S1289]) == (bounds_0[_S1288]))
                {
                    _S1290 = j_0 < k_5;
                }
                else
                {
                    _S1290 = false;
                }
            }
            if(_S1290)
            {
                rank_0 = rank_0 + u32(1);
            }
            j_0 = j_0 + u32(1);
        }
        order_0 = (order_0 | ((((k_5 + u32(1)) << ((u32(4) * rank_0))))));
        k_5 = k_5 + u32(1);
    }
    return order_0;
}

fn crossed_0( view_7 : RayView_0,  limit_3 : f32,  node_5 : u32) -> u32
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
        var _S1291 : f32;
        if((ray_child_0(node_5, slot_4)) == u32(4294967295))
        {
            _S1291 = 3.00000000549775576e+38f;
        }
        else
        {
            _S1291 = ray_bound_0(view_7, limit_3, node_5, slot_4);
        }
        bounds_1[slot_4] = _S1291;
        slot_4 = slot_4 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_4 : f32,  largest_1 : f32) -> f32
{
    return min(product_4, largest_1);
}

fn corner_0( ray_1 : Ray_0,  axes_9 : u32,  at_18 : u32) -> vec3<f32>
{
    var relative_0 : vec3<f32> = primitive_vector_0(at_18) - ray_1.origin_0;
    var z_7 : f32 = component_0(relative_0, (axes_9 >> (u32(4))));
    return vec3<f32>(component_0(relative_0, (axes_9 & (u32(3)))) - rounded_0(ray_1.shear_x_0 * z_7, ray_1.largest_0), component_0(relative_0, (((axes_9 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_1.shear_y_0 * z_7, ray_1.largest_0), z_7);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_4 : f32,
     v_9 : f32,
     w_8 : f32,
};

fn intersect_0( ray_2 : Ray_0,  axes_10 : u32,  at_19 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_4 = 0.0f;
    crossing_0.v_9 = 0.0f;
    crossing_0.w_8 = 0.0f;
    var a_19 : vec3<f32> = corner_0(ray_2, axes_10, at_19);
    var b_16 : vec3<f32> = corner_0(ray_2, axes_10, at_19 + u32(3));
    var c_7 : vec3<f32> = corner_0(ray_2, axes_10, at_19 + u32(6));
    var _S1292 : f32 = c_7.x;
    var _S1293 : f32 = b_16.y;
    var cx_by_0 : f32 = rounded_0(_S1292 * _S1293, ray_2.largest_0);
    var _S1294 : f32 = c_7.y;
    var _S1295 : f32 = b_16.x;
    var cy_bx_0 : f32 = rounded_0(_S1294 * _S1295, ray_2.largest_0);
    var _S1296 : f32 = a_19.x;
    var ax_cy_0 : f32 = rounded_0(_S1296 * _S1294, ray_2.largest_0);
    var _S1297 : f32 = a_19.y;
    var ay_cx_0 : f32 = rounded_0(_S1297 * _S1292, ray_2.largest_0);
    var bx_ay_0 : f32 = rounded_0(_S1295 * _S1297, ray_2.largest_0);
    var by_ax_0 : f32 = rounded_0(_S1293 * _S1296, ray_2.largest_0);
    var u_12 : f32 = cx_by_0 - cy_bx_0;
    var v_10 : f32 = ax_cy_0 - ay_cx_0;
    var w_9 : f32 = bx_ay_0 - by_ax_0;
    var _S1298 : f32 = min(min(u_12, v_10), w_9);
    var _S1299 : f32 = max(max(u_12, v_10), w_9);
    var _S1300 : bool;
    if(_S1298 < 0.0f)
    {
        _S1300 = _S1299 > 0.0f;
    }
    else
    {
        _S1300 = false;
    }
    if(_S1300)
    {
        return crossing_0;
    }
    var determinant_0 : f32 = u_12 + v_10 + w_9;
    if(_S1298 <= 0.0f)
    {
        _S1300 = _S1299 >= 0.0f;
    }
    else
    {
        _S1300 = false;
    }
    if(_S1300)
    {
        if((abs(determinant_0)) <= (ray_2.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0f)
    {
        return crossing_0;
    }
    var t_5 : f32 = (rounded_0(u_12 * a_19.z, ray_2.largest_0) + rounded_0(v_10 * b_16.z, ray_2.largest_0) + rounded_0(w_9 * c_7.z, ray_2.largest_0)) / determinant_0 * ray_2.inverse_z_0;
    if((ray_2.t_min_0) <= t_5)
    {
        _S1300 = t_5 <= (ray_2.t_max_0);
    }
    else
    {
        _S1300 = false;
    }
    crossing_0.is_hit_0 = _S1300;
    crossing_0.t_4 = t_5;
    crossing_0.v_9 = v_10 / determinant_0;
    crossing_0.w_8 = w_9 / determinant_0;
    return crossing_0;
}

fn face_6( triangle_7 : u32) -> u32
{
    return rough_0[triangle_7 / u32(4)][triangle_7 % u32(4)];
}

struct Found_0
{
     face_7 : u32,
     triangle_8 : u32,
     v_11 : f32,
     w_10 : f32,
};

fn first_found_0( view_8 : RayView_0,  ray_3 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S1301 : bool;
    var found_3 : Found_0;
    found_3.face_7 = u32(4294967295);
    found_3.triangle_8 = u32(4294967295);
    found_3.v_11 = 0.0f;
    found_3.w_10 = 0.0f;
    if(!((view_8.limit_0) >= 0.0f))
    {
        return found_3;
    }
    var way_2 : array<vec2<u32>, i32(40)>;
    way_2[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_8.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_2[level_0] = vec2<u32>(entered_0, crossed_0(view_8, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_2 : vec2<u32> = way_2[level_0];
        var _S1302 : u32 = way_2[level_0].y;
        if(_S1302 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S1303 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S1303;
            continue;
        }
        var slot_5 : u32 = ((_S1302 & (u32(15)))) - u32(1);
        way_2[level_0][i32(1)] = (_S1302 >> (u32(4)));
        var _S1304 : bool;
        if(!is_new_1)
        {
            _S1304 = (ray_bound_0(view_8, limit_4, here_2.x, slot_5)) > limit_4;
        }
        else
        {
            _S1304 = false;
        }
        if(_S1304)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_2.x, slot_5);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S1305 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S1305;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S1306 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S1307 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_3 : u32 = _S1307;
        for(;;)
        {
            if(i_3 < _S1306)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_3), view_8.axes_8, u32(9) * i_3);
            if(!crossing_1.is_hit_0)
            {
                i_3 = i_3 + u32(1);
                continue;
            }
            if((found_3.face_7) == u32(4294967295))
            {
                _S1301 = true;
            }
            else
            {
                _S1301 = (crossing_1.t_4) < ((*ray_3).t_max_0);
            }
            var _S1308 : bool;
            if(_S1301)
            {
                _S1308 = true;
            }
            else
            {
                _S1308 = (face_6(i_3)) < (found_3.face_7);
            }
            var limit_6 : f32;
            if(_S1308)
            {
                found_3.face_7 = face_6(i_3);
                found_3.triangle_8 = i_3;
                (*ray_3).t_max_0 = crossing_1.t_4;
                found_3.v_11 = crossing_1.v_9;
                found_3.w_10 = crossing_1.w_8;
                limit_6 = min(limit_5, crossing_1.t_4 * (*ray_3).local_per_t_0 - (*ray_3).enter_0 + 2.0f * view_8.margin_0);
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
            _S1301 = (found_3.face_7) != u32(4294967295);
        }
        else
        {
            _S1301 = false;
        }
        if(_S1301)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_3;
}

fn cast_0( origin_2 : vec3<f32>,  direction_17 : vec3<f32>,  t_min_2 : f32,  t_max_2 : f32,  any_1 : bool,  t_6 : ptr<function, f32>) -> Found_0
{
    var view_9 : RayView_0;
    var _S1309 : u32 = view_9.axes_8;
    var _S1310 : Ray_0 = ray_along_0(origin_2, direction_17, t_min_2, t_max_2, &(_S1309));
    view_9.axes_8 = _S1309;
    var ray_4 : Ray_0 = _S1310;
    var _S1311 : vec3<f32> = direction_17 / vec3<f32>(ray_4.local_per_t_0);
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
        var _S1312 : f32 = max(abs(_S1311[axis_4]), 8.67361737988403547e-19f);
        var _S1313 : f32;
        if((_S1311[axis_4]) < 0.0f)
        {
            _S1313 = -1.0f / _S1312;
        }
        else
        {
            _S1313 = 1.0f / _S1312;
        }
        view_9.inverse_3[axis_4] = _S1313;
        axis_4 = axis_4 + u32(1);
    }
    var offset_4 : vec3<f32> = origin_2 * view_9.inverse_3;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_9.inverse_3);
    view_9.offset_near_0 = offset_4 + wider_0;
    view_9.offset_far_0 = offset_4 - wider_0;
    view_9.limit_0 = min(t_max_2 * ray_4.local_per_t_0, 8.0f) + 3.814697265625e-06f;
    view_9.margin_0 = 3.814697265625e-06f;
    var found_4 : Found_0 = first_found_0(view_9, &(ray_4), any_1);
    (*t_6) = ray_4.t_max_0;
    return found_4;
}

fn place_of_0( found_5 : Found_0) -> Place_0
{
    return exact_place_0(found_5.triangle_8, found_5.v_11, found_5.w_10);
}

fn emitter_seen_0( found_6 : Found_0,  direction_18 : vec3<f32>) -> u32
{
    if((found_6.face_7) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_6 : u32 = word_0(shape_of_0(found_6.triangle_8) + u32(4));
    var _S1314 : bool;
    if(emitter_6 != u32(4294967295))
    {
        _S1314 = (dot(cross_of_0(found_6.triangle_8), direction_18)) < 0.0f;
    }
    else
    {
        _S1314 = false;
    }
    var _S1315 : u32;
    if(_S1314)
    {
        _S1315 = emitter_6;
    }
    else
    {
        _S1315 = u32(4294967295);
    }
    return _S1315;
}

fn area_pdf_0( record_14 : u32,  face_8 : u32,  from_2 : Surface_0,  direction_19 : vec3<f32>,  distance_7 : f32) -> f32
{
    var own_3 : f32;
    var rectangle_1 : u32 = word_0(record_14 + u32(4));
    if(rectangle_1 != u32(4294967295))
    {
        var _S1316 : SeenRectangle_0 = seen_rectangle_0(rectangle_1, from_2.position_0);
        if(!((_S1316.solid_angle_0) > 0.0f))
        {
            return 0.0f;
        }
        if((_S1316.solid_angle_0) >= 0.00100000004749745f)
        {
            return 1.0f / _S1316.solid_angle_0;
        }
    }
    var _S1317 : u32 = word_0(word_0(record_14 + u32(7)) + face_8);
    var nodes_at_2 : u32 = word_0(record_14 + u32(5));
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
        var is_second_1 : bool = _S1317 >= (word_0(nodes_at_2 + u32(17) * word_0(node_6 + u32(3))));
        if(is_second_1)
        {
            own_3 = shares_1.y;
        }
        else
        {
            own_3 = shares_1.x;
        }
        var chosen_3 : f32 = chosen_2 * own_3;
        var _S1318 : i32;
        if(is_second_1)
        {
            _S1318 = i32(3);
        }
        else
        {
            _S1318 = i32(2);
        }
        node_6 = nodes_at_2 + u32(17) * word_0(node_6 + u32(_S1318));
        chosen_2 = chosen_3;
    }
    var _S1319 : u32 = word_0(record_14 + u32(6));
    var _S1320 : u32 = word_0(node_6);
    own_3 = 0.0f;
    var k_6 : u32 = _S1320;
    var total_3 : f32 = 0.0f;
    for(;;)
    {
        if(k_6 < (word_0(node_6 + u32(1))))
        {
        }
        else
        {
            break;
        }
        var angle_6 : f32 = face_solid_angle_0(record_14, word_0(_S1319 + k_6), from_2.exact_0);
        var total_4 : f32 = total_3 + angle_6;
        if(k_6 == _S1317)
        {
            own_3 = angle_6;
        }
        k_6 = k_6 + u32(1);
        total_3 = total_4;
    }
    if(!(own_3 > 0.0f))
    {
        return 0.0f;
    }
    return chosen_2 / total_3 * density_of_0(own_3, cross_of_0(emitter_triangle_0(record_14, face_8)), distance_7, direction_19);
}

fn emitter_pdf_0( emitter_7 : u32,  found_7 : Found_0,  vertex_9 : Vertex_0,  direction_20 : vec3<f32>,  t_7 : f32) -> f32
{
    var record_15 : u32 = emitter_record_0(emitter_7);
    if(is_map_0(record_15))
    {
        var _S1321 : f32 = map_pdf_0(word_0(record_15 + u32(1)), direction_20);
        return _S1321;
    }
    if(!is_area_0(record_15))
    {
        return max(dot(vertex_9.axes_4.n_0, direction_20), 0.0f) * 0.31830987334251404f;
    }
    return area_pdf_0(record_15, found_7.face_7 - word_0(record_15 + u32(3)), vertex_9.surface_3, direction_20, t_7);
}

fn met_0( vertex_10 : Vertex_0,  direction_21 : vec3<f32>,  t_8 : f32,  place_17 : Place_0) -> Place_0
{
    return place_17;
}

fn weight_over_0( own_4 : f32,  other_0 : f32) -> f32
{
    var ratio_0 : f32 = other_0 / own_4;
    if(ratio_0 > 9.9999998430674944e+17f)
    {
        return 0.0f;
    }
    return 1.0f / (own_4 * (1.0f + ratio_0 * ratio_0));
}

fn in_map_0( map_6 : u32,  direction_22 : vec3<f32>) -> Lookup_0
{
    var place_18 : vec2<f32> = map_place_0(map_6, direction_22);
    var point_2 : Point_0;
    point_2.value_5 = place_18;
    point_2.by_first_1 = vec2<f32>(1.0f, 0.0f);
    point_2.by_second_1 = vec2<f32>(0.0f, 1.0f);
    var x_24 : i32 = floor_of_0(place_18.x);
    var y_9 : i32 = floor_of_0(place_18.y);
    var width_4 : i32 = i32(word_0(map_6));
    var height_1 : i32 = i32(word_0(map_6 + u32(1)));
    var left_1 : u32 = wrapped_0(x_24, width_4, u32(0));
    var right_1 : u32 = wrapped_0(x_24 + i32(1), width_4, u32(0));
    var _S1322 : u32 = wrapped_0(y_9, height_1, u32(2));
    var _S1323 : u32 = u32(width_4);
    var first_5 : u32 = _S1322 * _S1323;
    var _S1324 : u32 = wrapped_0(y_9 + i32(1), height_1, u32(2));
    var second_2 : u32 = _S1324 * _S1323;
    return between_0(vec4<u32>(first_5 + left_1, first_5 + right_1, second_2 + left_1, second_2 + right_1), point_2);
}

fn emitted_0( emitter_8 : u32,  place_19 : Place_0,  direction_23 : vec3<f32>) -> vec3<f32>
{
    var record_16 : u32 = emitter_record_0(emitter_8);
    var texture_6 : u32 = word_0(record_16 + u32(1));
    if(!is_map_0(record_16))
    {
        var _S1325 : vec3<f32> = shown_0(texture_6, place_19);
        return _S1325;
    }
    var change_1 : vec2<f32> = vec2<f32>(0.0f);
    var factor_1 : vec3<f32> = looked_up_0(word_0(texture_6 + u32(12)), one_texel_0(u32(0)), change_1);
    var _S1326 : u32 = word_0(texture_6 + u32(11));
    var _S1327 : Lookup_0 = in_map_0(texture_6, value_of_0(direction_23));
    return looked_up_0(_S1326, _S1327, change_1) * factor_1;
}

fn numbers_of_0( texture_7 : u32) -> u32
{
    return change_word_0(u32(7) + word_0(texture_7 + u32(18)));
}

fn add_to_sum_0( sum_6 : u32,  derivative_0 : f32)
{
    if(!((abs(derivative_0)) < 3.00000000549775576e+38f))
    {
        var _S1328 : u32 = atomicAdd(&(sums_0[u32(1)]), u32(1));
        return;
    }
    var scaled_0 : f32 = derivative_0 * (bitcast<f32>((change_word_0(u32(2)))));
    var size_3 : f32 = abs(scaled_0);
    if(size_3 > 7.73712524553362672e+25f)
    {
        var _S1329 : u32 = atomicAdd(&(sums_0[u32(0)]), u32(1));
        return;
    }
    var _S1330 : bool = scaled_0 < 0.0f;
    var _S1331 : i32;
    if(size_3 >= 1.84467440737095516e+19f)
    {
        _S1331 = i32(1);
    }
    else
    {
        _S1331 = i32(0);
    }
    var first_6 : u32 = u32(_S1331);
    var size_4 : f32;
    if(first_6 == u32(1))
    {
        size_4 = size_3 * 2.32830643653869629e-10f;
    }
    else
    {
        size_4 = size_3;
    }
    var higher_0 : f32 = floor(size_4 * 2.32830643653869629e-10f);
    var lower_0 : f32 = size_4 - higher_0 * 4.294967296e+09f;
    if(first_6 == u32(0))
    {
        size_4 = lower_0 + 0.5f;
    }
    else
    {
        size_4 = lower_0;
    }
    var _S1332 : u32 = u32(4) + u32(4) * sum_6;
    var digits_0 : vec2<u32> = vec2<u32>(u32(size_4), u32(higher_0));
    var k_7 : u32 = first_6;
    for(;;)
    {
        var _S1333 : bool;
        if(k_7 < u32(4))
        {
            _S1333 = (((digits_0.x) | ((digits_0.y)))) != u32(0);
        }
        else
        {
            _S1333 = false;
        }
        if(_S1333)
        {
        }
        else
        {
            break;
        }
        var _S1334 : u32;
        if(_S1330)
        {
            _S1334 = u32(0) - digits_0.x;
        }
        else
        {
            _S1334 = digits_0.x;
        }
        var before_0 : u32 = atomicAdd(&(sums_0[_S1332 + k_7]), _S1334);
        var overflows_0 : bool;
        if(_S1330)
        {
            overflows_0 = before_0 < (digits_0.x);
        }
        else
        {
            overflows_0 = (before_0 + digits_0.x) < before_0;
        }
        var _S1335 : u32 = digits_0.y;
        if(overflows_0)
        {
            _S1331 = i32(1);
        }
        else
        {
            _S1331 = i32(0);
        }
        var _S1336 : vec2<u32> = vec2<u32>(_S1335 + u32(_S1331), u32(0));
        var _S1337 : u32 = k_7 + u32(1);
        digits_0 = _S1336;
        k_7 = _S1337;
    }
    return;
}

fn add_to_texels_0( texture_8 : u32,  lookup_5 : Lookup_0,  derivative_1 : vec3<f32>)
{
    var first_7 : u32 = numbers_of_0(texture_8);
    var _S1338 : u32 = word_0(texture_8 + u32(1));
    var _S1339 : u32;
    if(first_7 == u32(4294967295))
    {
        _S1339 = u32(0);
    }
    else
    {
        _S1339 = lookup_5.count_0;
    }
    var k_8 : u32 = u32(0);
    for(;;)
    {
        if(k_8 < _S1339)
        {
        }
        else
        {
            break;
        }
        var own_5 : vec3<f32> = derivative_1 * vec3<f32>(lookup_5.weights_1[k_8]);
        var own_6 : vec3<f32>;
        if(_S1338 == u32(1))
        {
            own_6 = vec3<f32>((own_5.x + own_5.y + own_5.z));
        }
        else
        {
            own_6 = own_5;
        }
        var c_8 : u32 = u32(0);
        for(;;)
        {
            if(c_8 < _S1338)
            {
            }
            else
            {
                break;
            }
            add_to_sum_0(first_7 + _S1338 * lookup_5.texels_0[k_8] + c_8, own_6[c_8]);
            c_8 = c_8 + u32(1);
        }
        k_8 = k_8 + u32(1);
    }
    return;
}

fn lookup_back_0( texture_9 : u32,  lookup_6 : Lookup_0,  derivative_2 : vec3<f32>) -> vec2<f32>
{
    add_to_texels_0(texture_9, lookup_6, derivative_2);
    return vec2<f32>(dot(weighted_texels_0(texture_9, lookup_6, lookup_6.by_first_0), derivative_2), dot(weighted_texels_0(texture_9, lookup_6, lookup_6.by_second_0), derivative_2));
}

fn is_moving_0() -> bool
{
    return (change_word_0(u32(0))) != u32(4294967295);
}

struct AtCorners_0
{
     a_20 : vec3<f32>,
     b_17 : vec3<f32>,
     c_9 : vec3<f32>,
};

fn at_no_corner_0() -> AtCorners_0
{
    var corners_3 : AtCorners_0;
    var _S1340 : vec3<f32> = vec3<f32>(0.0f);
    corners_3.c_9 = _S1340;
    corners_3.b_17 = _S1340;
    corners_3.a_20 = _S1340;
    return corners_3;
}

fn add_at_place_0( corners_4 : ptr<function, AtCorners_0>,  place_20 : Place_0,  derivative_3 : vec3<f32>)
{
    (*corners_4).a_20 = (*corners_4).a_20 + derivative_3 * vec3<f32>((1.0f - place_20.v_0 - place_20.w_0));
    (*corners_4).b_17 = (*corners_4).b_17 + derivative_3 * vec3<f32>(place_20.v_0);
    (*corners_4).c_9 = (*corners_4).c_9 + derivative_3 * vec3<f32>(place_20.w_0);
    return;
}

fn add_at_place_1( corners_5 : ptr<function, AtCorners_0>,  place_21 : Place_0,  derivative_4 : vec3<f32>)
{
    (*corners_5).a_20 = (*corners_5).a_20 + derivative_4 * vec3<f32>((1.0f - place_21.v_0 - place_21.w_0));
    (*corners_5).b_17 = (*corners_5).b_17 + derivative_4 * vec3<f32>(place_21.v_0);
    (*corners_5).c_9 = (*corners_5).c_9 + derivative_4 * vec3<f32>(place_21.w_0);
    return;
}

fn place_back_0( points_0 : ptr<function, AtCorners_0>,  place_22 : Place_0,  by_place_0 : vec2<f32>,  by_position_0 : vec3<f32>,  direction_24 : vec3<f32>) -> vec3<f32>
{
    var corner_1 : u32 = u32(9) * place_22.triangle_0;
    var a_21 : vec3<f32> = primitive_vector_0(corner_1);
    var ab_2 : vec3<f32> = primitive_vector_0(corner_1 + u32(3)) - a_21;
    var ac_1 : vec3<f32> = primitive_vector_0(corner_1 + u32(6)) - a_21;
    var across_2 : vec3<f32> = cross(ab_2, ac_1);
    var _S1341 : f32 = max(max(abs(across_2.x), abs(across_2.y)), abs(across_2.z));
    var normal_9 : vec3<f32> = across_2 / vec3<f32>(_S1341);
    var by_slip_0 : vec3<f32> = by_position_0 + (cross(ac_1, normal_9) * vec3<f32>(by_place_0.x) + cross(normal_9, ab_2) * vec3<f32>(by_place_0.y)) * vec3<f32>((1.0f / (dot(normal_9, normal_9) * _S1341)));
    var by_drift_0 : vec3<f32> = by_slip_0 - normal_9 * vec3<f32>((dot(direction_24, by_slip_0) / dot(normal_9, direction_24)));
    add_at_place_1(&((*points_0)), place_22, by_position_0 - by_drift_0);
    return by_drift_0;
}

fn points_of_0( triangle_9 : u32) -> u32
{
    return change_word_0(change_word_0(u32(0)) + u32(2) * word_0(triangle_record_0(triangle_9)));
}

fn add_to_sums_0( first_8 : u32,  derivative_5 : vec3<f32>)
{
    var _S1342 : i32;
    if(first_8 == u32(4294967295))
    {
        _S1342 = i32(0);
    }
    else
    {
        _S1342 = i32(3);
    }
    var _S1343 : u32 = u32(_S1342);
    var axis_5 : u32 = u32(0);
    for(;;)
    {
        if(axis_5 < _S1343)
        {
        }
        else
        {
            break;
        }
        add_to_sum_0(first_8 + axis_5, derivative_5[axis_5]);
        axis_5 = axis_5 + u32(1);
    }
    return;
}

fn add_to_corners_0( sums_at_0 : u32,  triangle_10 : u32,  corners_6 : AtCorners_0)
{
    var _S1344 : u32 = triangle_record_0(triangle_10) + u32(2);
    var _S1345 : i32;
    if(sums_at_0 == u32(4294967295))
    {
        _S1345 = i32(0);
    }
    else
    {
        _S1345 = i32(3);
    }
    var _S1346 : u32 = u32(_S1345);
    var k_9 : u32 = u32(0);
    for(;;)
    {
        if(k_9 < _S1346)
        {
        }
        else
        {
            break;
        }
        var _S1347 : u32 = sums_at_0 + u32(3) * word_0(_S1344 + k_9);
        var _S1348 : vec3<f32>;
        if(k_9 == u32(0))
        {
            _S1348 = corners_6.a_20;
        }
        else
        {
            if(k_9 == u32(1))
            {
                _S1348 = corners_6.b_17;
            }
            else
            {
                _S1348 = corners_6.c_9;
            }
        }
        add_to_sums_0(_S1347, _S1348);
        k_9 = k_9 + u32(1);
    }
    return;
}

fn emitted_back_0( by_start_0 : ptr<function, vec3<f32>>,  emitter_9 : u32,  place_23 : Place_0,  direction_25 : vec3<f32>,  t_9 : f32,  importance_0 : vec3<f32>) -> vec3<f32>
{
    var record_17 : u32 = emitter_record_0(emitter_9);
    var texture_10 : u32 = word_0(record_17 + u32(1));
    var lookup_7 : Lookup_0;
    var by_texels_0 : vec3<f32>;
    if(is_map_0(record_17))
    {
        var scale_3 : u32 = word_0(texture_10 + u32(12));
        var lookup_8 : Lookup_0 = in_map_0(texture_10, direction_25);
        var _S1349 : Lookup_0 = one_texel_0(u32(0));
        var by_texels_1 : vec3<f32> = importance_0 * weighted_texels_0(scale_3, _S1349, vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f));
        add_to_texels_0(scale_3, _S1349, importance_0 * weighted_texels_0(word_0(texture_10 + u32(11)), lookup_8, lookup_8.weights_1));
        lookup_7 = lookup_8;
        by_texels_0 = by_texels_1;
    }
    else
    {
        var _S1350 : Lookup_0 = lookup_at_0(texture_10, place_23);
        lookup_7 = _S1350;
        by_texels_0 = importance_0;
    }
    var _S1351 : u32;
    if(is_map_0(record_17))
    {
        _S1351 = word_0(texture_10 + u32(11));
    }
    else
    {
        _S1351 = texture_10;
    }
    var by_place_1 : vec2<f32> = lookup_back_0(_S1351, lookup_7, by_texels_0);
    if(is_map_0(record_17))
    {
        var _S1352 : vec3<f32> = vec3<f32>(0.0f);
        var moving_1 : DiffPair_vectorx3Cfloatx2C3x3E_0;
        moving_1.primal_0 = direction_25;
        moving_1.differential_0 = _S1352;
        _S1105(texture_10, &(moving_1), by_place_1);
        return moving_1.differential_0;
    }
    var _S1353 : bool;
    if(!is_area_0(record_17))
    {
        _S1353 = true;
    }
    else
    {
        _S1353 = !is_moving_0();
    }
    if(_S1353)
    {
        _S1353 = true;
    }
    else
    {
        _S1353 = (all((by_place_1 == vec2<f32>(0.0f))));
    }
    if(_S1353)
    {
        return vec3<f32>(0.0f);
    }
    var points_1 : AtCorners_0 = at_no_corner_0();
    var by_drift_1 : vec3<f32> = place_back_0(&(points_1), place_23, by_place_1, vec3<f32>(0.0f), direction_25);
    add_to_corners_0(points_of_0(place_23.triangle_0), place_23.triangle_0, points_1);
    (*by_start_0) = (*by_start_0) + by_drift_1;
    return by_drift_1 * vec3<f32>(t_9);
}

fn axes_back_0( axes_11 : ptr<function, Axes_0>,  local_2 : vec3<f32>,  world_0 : vec3<f32>)
{
    (*axes_11).s_0 = (*axes_11).s_0 + world_0 * vec3<f32>(local_2.x);
    (*axes_11).t_0 = (*axes_11).t_0 + world_0 * vec3<f32>(local_2.y);
    (*axes_11).n_0 = (*axes_11).n_0 + world_0 * vec3<f32>(local_2.z);
    return;
}

fn scattered_back_0( pulled_1 : ptr<function, Pulled_0>,  vertex_11 : Vertex_0,  wo_8 : vec3<f32>,  direction_26 : vec3<f32>,  is_specular_3 : bool,  by_value_0 : vec3<f32>) -> vec3<f32>
{
    var _S1354 : Numbers_0 = no_numbers_0();
    var numbers_9 : DiffPair_Numbers_0;
    numbers_9.primal_0 = vertex_11.lobe_6.numbers_0;
    numbers_9.differential_0 = _S1354;
    var _S1355 : vec3<f32> = vec3<f32>(0.0f);
    var wi_11 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    wi_11.primal_0 = vertex_11.wi_1;
    wi_11.differential_0 = _S1355;
    var onward_1 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    onward_1.primal_0 = wo_8;
    onward_1.differential_0 = _S1355;
    if(is_specular_3)
    {
        _S1014(vertex_11.lobe_6, &(numbers_9), &(wi_11), by_value_0);
    }
    else
    {
        var by_scattering_0 : Scattering_Differential_0;
        by_scattering_0.value_0 = by_value_0;
        _S956(vertex_11.lobe_6, &(numbers_9), &(wi_11), &(onward_1), by_scattering_0);
        var _S1356 : Axes_0 = (*pulled_1).axes_5;
        axes_back_0(&(_S1356), onward_1.differential_0, direction_26);
        (*pulled_1).axes_5 = _S1356;
    }
    (*pulled_1).numbers_4 = Numbers_x24_syn_dadd_0((*pulled_1).numbers_4, numbers_9.differential_0);
    (*pulled_1).wi_2 = (*pulled_1).wi_2 + wi_11.differential_0;
    var _S1357 : vec3<f32>;
    if(is_specular_3)
    {
        _S1357 = _S1355;
    }
    else
    {
        _S1357 = to_world_0(vertex_11.axes_4, onward_1.differential_0);
    }
    return _S1357;
}

fn specular_direction_back_0( pulled_2 : ptr<function, Pulled_0>,  vertex_12 : Vertex_0,  wo_9 : vec3<f32>,  by_direction_0 : vec3<f32>)
{
    var local_3 : vec3<f32> = to_local_0(vertex_12.axes_4, by_direction_0);
    var _S1358 : Axes_0 = (*pulled_2).axes_5;
    axes_back_0(&(_S1358), wo_9, by_direction_0);
    (*pulled_2).axes_5 = _S1358;
    (*pulled_2).wi_2 = (*pulled_2).wi_2 + vec3<f32>((vec2<f32>(0) - local_3.xy), local_3.z);
    return;
}

fn turns_1( vertex_13 : Vertex_0) -> bool
{
    return (change_word_0(u32(1))) != u32(0);
}

fn turning_back_0( pulled_3 : ptr<function, Pulled_0>,  vertex_14 : Vertex_0,  direction_27 : vec3<f32>,  by_direction_1 : vec3<f32>)
{
    if(turns_1(vertex_14))
    {
        (*pulled_3).axes_5.n_0 = (*pulled_3).axes_5.n_0 + (by_direction_1 * vec3<f32>(dot(vertex_14.axes_4.n_0, direction_27)) - direction_27 * vec3<f32>(dot(vertex_14.axes_4.n_0, by_direction_1)));
    }
    return;
}

fn direct_back_0( pulled_4 : ptr<function, Pulled_0>,  vertex_15 : Vertex_0,  emitter_10 : u32,  place_24 : Place_0,  wo_10 : vec3<f32>,  direction_28 : vec3<f32>,  is_specular_4 : bool,  t_10 : f32,  scattered_4 : Scattered_0,  weight_0 : f32,  light_1 : vec3<f32>,  importance_1 : vec3<f32>)
{
    var _S1359 : vec3<f32> = importance_1 * scattered_4.value_9 * vec3<f32>(weight_0);
    var _S1360 : vec3<f32> = (*pulled_4).position_2;
    var by_direction_2 : vec3<f32> = emitted_back_0(&(_S1360), emitter_10, place_24, direction_28, t_10, _S1359);
    (*pulled_4).position_2 = _S1360;
    var _S1361 : vec3<f32> = scattered_back_0(&((*pulled_4)), vertex_15, wo_10, direction_28, is_specular_4, importance_1 * light_1);
    var by_direction_3 : vec3<f32> = by_direction_2 + _S1361;
    if(is_specular_4)
    {
        specular_direction_back_0(&((*pulled_4)), vertex_15, wo_10, by_direction_3);
    }
    else
    {
        if((word_0(emitter_record_0(emitter_10))) == u32(1))
        {
            turning_back_0(&((*pulled_4)), vertex_15, direction_28, by_direction_3);
        }
    }
    return;
}

fn slot_derivative_0( numbers_10 : Numbers_0,  slot_6 : u32) -> vec3<f32>
{
    switch(slot_6)
    {
    case u32(0):
        {
            return numbers_10.diffuse_reflectance_0;
        }
    case u32(1):
        {
            return numbers_10.specular_reflectance_0;
        }
    case u32(2):
        {
            return numbers_10.eta_0;
        }
    case u32(3):
        {
            return numbers_10.k_0;
        }
    case u32(4):
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_10.alpha_0.x);
        }
    default :
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_10.alpha_0.y);
        }
    }
}

fn numbers_back_0( material_1 : u32,  place_25 : Place_0,  numbers_11 : Numbers_0) -> vec2<f32>
{
    var _S1362 : vec2<f32> = vec2<f32>(0.0f);
    var _S1363 : u32 = word_0(material_1 + u32(4));
    var slot_7 : u32 = u32(0);
    var by_place_2 : vec2<f32> = _S1362;
    for(;;)
    {
        if(slot_7 < _S1363)
        {
        }
        else
        {
            break;
        }
        var texture_11 : u32 = word_0(material_1 + u32(5) + slot_7);
        if(texture_11 == u32(4294967295))
        {
            slot_7 = slot_7 + u32(1);
            continue;
        }
        var _S1364 : Lookup_0 = lookup_at_0(texture_11, place_25);
        var _S1365 : vec2<f32> = lookup_back_0(texture_11, _S1364, slot_derivative_0(numbers_11, slot_7));
        by_place_2 = by_place_2 + _S1365;
        slot_7 = slot_7 + u32(1);
    }
    return by_place_2;
}

fn unit_back_0( vector_1 : vec3<f32>,  derivative_6 : vec3<f32>,  size_5 : f32) -> vec3<f32>
{
    return (derivative_6 - vector_1 * vec3<f32>(dot(vector_1, derivative_6))) / vec3<f32>(size_5);
}

fn tangent_back_0( points_2 : ptr<function, AtCorners_0>,  triangle_11 : u32,  tangent_3 : vec3<f32>,  by_tangent_0 : vec3<f32>)
{
    var corner_2 : u32 = u32(9) * triangle_11;
    var uvs_2 : Corners2_0 = uvs_of_0(triangle_11);
    var first_9 : vec2<f32> = uvs_2.b_4 - uvs_2.a_7;
    var second_3 : vec2<f32> = uvs_2.c_1 - uvs_2.a_7;
    var _S1366 : f32 = second_3.y;
    var _S1367 : f32 = first_9.y;
    var scale_4 : f32 = 1.0f / (first_9.x * _S1366 - second_3.x * _S1367);
    var of_ab_0 : f32 = _S1366 * scale_4;
    var of_ac_0 : f32 = - _S1367 * scale_4;
    var a_22 : vec3<f32> = primitive_vector_0(corner_2);
    var _S1368 : vec3<f32> = vec3<f32>(of_ab_0);
    var _S1369 : vec3<f32> = vec3<f32>(of_ac_0);
    var derivative_7 : vec3<f32> = unit_back_0(tangent_3, by_tangent_0, length((primitive_vector_0(corner_2 + u32(3)) - a_22) * _S1368 + (primitive_vector_0(corner_2 + u32(6)) - a_22) * _S1369));
    (*points_2).a_20 = (*points_2).a_20 - derivative_7 * vec3<f32>((of_ab_0 + of_ac_0));
    (*points_2).b_17 = (*points_2).b_17 + derivative_7 * _S1368;
    (*points_2).c_9 = (*points_2).c_9 + derivative_7 * _S1369;
    return;
}

fn normals_of_0( triangle_12 : u32) -> u32
{
    return change_word_0(change_word_0(u32(0)) + u32(2) * word_0(triangle_record_0(triangle_12)) + u32(1));
}

fn surface_back_0( points_3 : ptr<function, AtCorners_0>,  surface_5 : Surface_0,  by_place_3 : vec2<f32>,  by_position_1 : vec3<f32>,  by_outward_0 : vec3<f32>,  direction_29 : vec3<f32>) -> vec3<f32>
{
    var normals_1 : u32 = word_0(surface_5.shape_0);
    var _S1370 : vec2<f32>;
    if(normals_1 == u32(4294967295))
    {
        var corner_3 : u32 = u32(9) * surface_5.place_5.triangle_0;
        var a_23 : vec3<f32> = primitive_vector_0(corner_3);
        var ab_3 : vec3<f32> = primitive_vector_0(corner_3 + u32(3)) - a_23;
        var ac_2 : vec3<f32> = primitive_vector_0(corner_3 + u32(6)) - a_23;
        var derivative_8 : vec3<f32> = unit_back_0(surface_5.outward_0, by_outward_0, length(cross(ab_3, ac_2)));
        var by_ab_0 : vec3<f32> = cross(ac_2, derivative_8);
        var by_ac_0 : vec3<f32> = cross(derivative_8, ab_3);
        (*points_3).a_20 = (*points_3).a_20 - (by_ab_0 + by_ac_0);
        (*points_3).b_17 = (*points_3).b_17 + by_ab_0;
        (*points_3).c_9 = (*points_3).c_9 + by_ac_0;
        _S1370 = by_place_3;
    }
    else
    {
        var record_18 : u32 = triangle_record_0(surface_5.place_5.triangle_0) + u32(2);
        var a_24 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_18));
        var ab_4 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_18 + u32(1))) - a_24;
        var ac_3 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_18 + u32(2))) - a_24;
        var derivative_9 : vec3<f32> = unit_back_0(surface_5.outward_0, by_outward_0, length(a_24 + ab_4 * vec3<f32>(surface_5.place_5.v_0) + ac_3 * vec3<f32>(surface_5.place_5.w_0)));
        var of_normals_0 : AtCorners_0 = at_no_corner_0();
        add_at_place_0(&(of_normals_0), surface_5.place_5, derivative_9);
        add_to_corners_0(normals_of_0(surface_5.place_5.triangle_0), surface_5.place_5.triangle_0, of_normals_0);
        _S1370 = by_place_3 + vec2<f32>(dot(ab_4, derivative_9), dot(ac_3, derivative_9));
    }
    var _S1371 : vec3<f32> = place_back_0(&((*points_3)), surface_5.place_5, _S1370, by_position_1, direction_29);
    return _S1371;
}

fn vertex_back_0( pulled_5 : Pulled_0,  vertex_16 : Vertex_0,  material_2 : u32,  direction_30 : vec3<f32>) -> ByRay_0
{
    var by_ray_2 : ByRay_0;
    var _S1372 : vec3<f32> = vec3<f32>(0.0f);
    by_ray_2.direction_0 = _S1372;
    by_ray_2.drift_0 = _S1372;
    var by_place_4 : vec2<f32> = numbers_back_0(material_2, vertex_16.surface_3.place_5, pulled_5.numbers_4);
    if(!is_moving_0())
    {
        return by_ray_2;
    }
    var _S1373 : Axes_0 = Axes_x24_syn_dzero_0();
    var towards_1 : DiffPair_Axes_0;
    towards_1.primal_0 = vertex_16.axes_4;
    towards_1.differential_0 = _S1373;
    var incoming_0 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    incoming_0.primal_0 = direction_30;
    incoming_0.differential_0 = _S1372;
    _S220(&(towards_1), &(incoming_0), pulled_5.wi_2);
    by_ray_2.direction_0 = incoming_0.differential_0;
    var outward_1 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    outward_1.primal_0 = vertex_16.surface_3.outward_0;
    outward_1.differential_0 = _S1372;
    var _S1374 : vec3<f32> = tangent_at_0(vertex_16.surface_3);
    var tangent_4 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    tangent_4.primal_0 = _S1374;
    tangent_4.differential_0 = _S1372;
    var by_axes_0 : Axes_0 = Axes_x24_syn_dadd_0(pulled_5.axes_5, towards_1.differential_0);
    var points_4 : AtCorners_0 = at_no_corner_0();
    if((any((_S1374 != _S1372))))
    {
        _S171(&(outward_1), &(tangent_4), vertex_16.surface_3.is_front_0, by_axes_0);
        tangent_back_0(&(points_4), vertex_16.surface_3.place_5.triangle_0, tangent_4.primal_0, tangent_4.differential_0);
    }
    else
    {
        _S140(&(outward_1), vertex_16.surface_3.is_front_0, by_axes_0);
    }
    var _S1375 : vec3<f32> = surface_back_0(&(points_4), vertex_16.surface_3, by_place_4, pulled_5.position_2, outward_1.differential_0, direction_30);
    by_ray_2.drift_0 = _S1375;
    add_to_corners_0(points_of_0(vertex_16.surface_3.place_5.triangle_0), vertex_16.surface_3.place_5.triangle_0, points_4);
    return by_ray_2;
}

fn take_further_0( path_7 : ptr<function, Path_0>,  reflected_1 : ptr<function, Reflected_0>,  importance_2 : vec3<f32>) -> bool
{
    var depth_3 : u32 = launch_0.depth_0;
    var _S1376 : u32 = vertex_numbers_0(launch_0.depth_0);
    var incoming_1 : vec3<f32> = value_of_0((*path_7).direction_1);
    var surface_6 : Surface_0 = surface_at_0((*path_7).place_3, incoming_1);
    var material_3 : u32 = material_of_0(surface_6);
    if(material_3 == u32(4294967295))
    {
        return false;
    }
    var vertex_17 : Vertex_0 = vertex_at_0(surface_6, material_3, (*path_7).direction_1);
    var emitter_samples_0 : u32 = word_0(u32(2));
    var _S1377 : u32 = word_0(u32(3));
    var _S1378 : bool = !reaches_0(depth_3 + u32(3));
    var goes_on_0 : bool;
    if(_S1378)
    {
        goes_on_0 = (vertex_17.lobe_6.kind_0) == u32(0);
    }
    else
    {
        goes_on_0 = false;
    }
    if(goes_on_0)
    {
        goes_on_0 = is_sampled_well_0(surface_6.position_0);
    }
    else
    {
        goes_on_0 = false;
    }
    var bsdf_samples_0 : u32;
    if(goes_on_0)
    {
        bsdf_samples_0 = u32(0);
    }
    else
    {
        bsdf_samples_0 = _S1377;
    }
    var on_emitters_0 : u32;
    if(has_smooth_0(vertex_17.lobe_6))
    {
        on_emitters_0 = emitter_samples_0;
    }
    else
    {
        on_emitters_0 = u32(0);
    }
    var pulled_6 : Pulled_0 = nothing_pulled_0();
    var _S1379 : Choice_0 = choice_at_0(surface_6.position_0, vertex_17.axes_4.n_0, on_emitters_0 == u32(0));
    goes_on_0 = false;
    var next_3 : Place_0 = (*path_7).place_3;
    var next_direction_0 : vec3<f32> = (*path_7).direction_1;
    var i_4 : u32 = u32(0);
    for(;;)
    {
        if(i_4 < (on_emitters_0 + bsdf_samples_0))
        {
        }
        else
        {
            break;
        }
        var sample_3 : LightSample_0;
        var goes_on_1 : bool;
        var next_4 : Place_0;
        var next_direction_1 : vec3<f32>;
        if(i_4 < on_emitters_0)
        {
            var _S1380 : bool = sample_emitter_0(vertex_17, _S1379, (*path_7).key_0, _S1376 + u32(3) * i_4, &(sample_3));
            if(!_S1380)
            {
                goes_on_1 = goes_on_0;
                next_4 = next_3;
                next_direction_1 = next_direction_0;
                var _S1381 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_3 = next_4;
                next_direction_0 = next_direction_1;
                i_4 = _S1381;
                continue;
            }
        }
        else
        {
            sample_3 = sample_material_0(vertex_17, (*path_7).key_0, first_material_number_0(depth_3) + u32(3) * (i_4 - on_emitters_0));
        }
        var moving_2 : vec3<f32>;
        var scattered_5 : Scattered_0 = scattered_along_0(vertex_17, sample_3, walked_of_0((*path_7)), &(moving_2));
        var _S1382 : bool;
        if(!sample_3.is_on_emitter_0)
        {
            _S1382 = !((scattered_5.pdf_6) > 0.0f);
        }
        else
        {
            _S1382 = false;
        }
        if(_S1382)
        {
            goes_on_1 = goes_on_0;
            next_4 = next_3;
            next_direction_1 = next_direction_0;
            var _S1381 : u32 = i_4 + u32(1);
            goes_on_0 = goes_on_1;
            next_3 = next_4;
            next_direction_0 = next_direction_1;
            i_4 = _S1381;
            continue;
        }
        var t_11 : f32;
        var found_8 : Found_0 = cast_0(surface_6.exact_0, sample_3.way_1, sample_3.nearest_0, sample_3.farthest_0, sample_3.is_on_emitter_0, &(t_11));
        var own_7 : f32;
        var other_1 : f32;
        if(sample_3.is_on_emitter_0)
        {
            if((found_8.face_7) != u32(4294967295))
            {
                goes_on_1 = goes_on_0;
                next_4 = next_3;
                next_direction_1 = next_direction_0;
                var _S1381 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_3 = next_4;
                next_direction_0 = next_direction_1;
                i_4 = _S1381;
                continue;
            }
            var own_8 : f32 = f32(emitter_samples_0) * sample_3.probability_3 * sample_3.pdf_4;
            if(!(own_8 > 0.0f))
            {
                goes_on_1 = goes_on_0;
                next_4 = next_3;
                next_direction_1 = next_direction_0;
                var _S1381 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_3 = next_4;
                next_direction_0 = next_direction_1;
                i_4 = _S1381;
                continue;
            }
            var _S1383 : f32 = f32(bsdf_samples_0) * scattered_5.pdf_6;
            own_7 = own_8;
            other_1 = _S1383;
            goes_on_1 = goes_on_0;
            next_4 = next_3;
            next_direction_1 = next_direction_0;
        }
        else
        {
            if(i_4 == on_emitters_0)
            {
                var _S1384 : bool = (found_8.face_7) != u32(4294967295);
                var _S1385 : Place_0 = place_of_0(found_8);
                (*reflected_1).onward_0 = scattered_5.value_9 * vec3<f32>((1.0f / scattered_5.pdf_6));
                (*reflected_1).wo_0 = sample_3.wo_1;
                (*reflected_1).is_specular_0 = sample_3.is_specular_1;
                (*reflected_1).factor_0 = 1.0f / scattered_5.pdf_6;
                (*reflected_1).distance_1 = t_11;
                goes_on_1 = _S1384;
                next_4 = _S1385;
                next_direction_1 = moving_2;
            }
            else
            {
                goes_on_1 = goes_on_0;
                next_4 = next_3;
                next_direction_1 = next_direction_0;
            }
            var _S1386 : u32 = emitter_seen_0(found_8, sample_3.direction_10);
            sample_3.emitter_5 = _S1386;
            if(_S1386 == u32(4294967295))
            {
                var _S1381 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_3 = next_4;
                next_direction_0 = next_direction_1;
                i_4 = _S1381;
                continue;
            }
            sample_3.place_15 = place_of_0(found_8);
            sample_3.distance_6 = t_11;
            var _S1387 : f32 = f32(bsdf_samples_0) * scattered_5.pdf_6;
            var _S1388 : bool;
            if(!sample_3.is_specular_1)
            {
                _S1388 = emitter_samples_0 != u32(0);
            }
            else
            {
                _S1388 = false;
            }
            if(_S1388)
            {
                var pdf_7 : f32 = emitter_pdf_0(sample_3.emitter_5, found_8, vertex_17, sample_3.direction_10, t_11);
                own_7 = f32(emitter_samples_0) * chance_of_0(sample_3.emitter_5, _S1379) * pdf_7;
            }
            else
            {
                own_7 = 0.0f;
            }
            var _S1389 : f32 = own_7;
            own_7 = _S1387;
            other_1 = _S1389;
        }
        var place_26 : Place_0 = sample_3.place_15;
        var place_27 : Place_0;
        if(is_area_0(emitter_record_0(sample_3.emitter_5)))
        {
            place_27 = met_0(vertex_17, moving_2, sample_3.distance_6, place_26);
        }
        else
        {
            place_27 = place_26;
        }
        var weight_1 : f32 = weight_over_0(own_7, other_1);
        var _S1390 : vec3<f32> = emitted_0(sample_3.emitter_5, place_27, moving_2);
        var light_2 : vec3<f32> = _S1390 * vec3<f32>(weight_1);
        (*reflected_1).direct_0 = (*reflected_1).direct_0 + scattered_5.value_9 * light_2;
        direct_back_0(&(pulled_6), vertex_17, sample_3.emitter_5, place_27, sample_3.wo_1, sample_3.direction_10, sample_3.is_specular_1, sample_3.distance_6, scattered_5, weight_1, light_2, importance_2);
        var _S1381 : u32 = i_4 + u32(1);
        goes_on_0 = goes_on_1;
        next_3 = next_4;
        next_direction_0 = next_direction_1;
        i_4 = _S1381;
    }
    var _S1391 : ByRay_0 = vertex_back_0(pulled_6, vertex_17, material_3, incoming_1);
    (*reflected_1).by_ray_1 = _S1391;
    if(_S1378)
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
    var throughput_1 : vec3<f32> = value_of_0((*path_7).throughput_0) * value_of_0((*reflected_1).onward_0);
    var _S1392 : f32 = max(max(throughput_1.x, throughput_1.y), throughput_1.z);
    var _S1393 : u32 = depth_3 + u32(1);
    if(_S1393 >= (word_0(u32(1))))
    {
        var survival_0 : f32 = clamp(_S1392, 0.05000000074505806f, 0.94999998807907104f);
        if((random_0((*path_7).key_0, vertex_numbers_0(_S1393) - u32(1))) >= survival_0)
        {
            return false;
        }
        (*reflected_1).onward_0 = (*reflected_1).onward_0 * vec3<f32>((1.0f / survival_0));
        (*reflected_1).factor_0 = (*reflected_1).factor_0 / survival_0;
    }
    (*path_7).place_3 = next_3;
    (*path_7).direction_1 = next_direction_0;
    return true;
}

fn kept_at_0( depth_4 : u32) -> u32
{
    return u32(33) + u32(29) * depth_4;
}

fn set_word_0( path_8 : u32,  which_6 : u32,  value_10 : u32)
{
    paths_0[which_6 * launch_0.room_0 + path_8] = value_10;
    return;
}

fn set_vector_0( path_9 : u32,  which_7 : ptr<function, u32>,  value_11 : vec3<f32>)
{
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
        set_word_0(path_9, (*which_7) + axis_6, (bitcast<u32>((value_11[axis_6]))));
        axis_6 = axis_6 + u32(1);
    }
    (*which_7) = (*which_7) + u32(3);
    return;
}

fn set_vector_1( path_10 : u32,  which_8 : ptr<function, u32>,  value_12 : vec3<f32>)
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
        set_word_0(path_10, (*which_8) + axis_7, (bitcast<u32>((value_12[axis_7]))));
        axis_7 = axis_7 + u32(1);
    }
    (*which_8) = (*which_8) + u32(3);
    return;
}

fn set_vector_2( path_11 : u32,  which_9 : ptr<function, u32>,  value_13 : vec3<f32>)
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
        set_word_0(path_11, (*which_9) + axis_8, (bitcast<u32>((value_13[axis_8]))));
        axis_8 = axis_8 + u32(1);
    }
    (*which_9) = (*which_9) + u32(3);
    return;
}

fn set_place_0( path_12 : u32,  which_10 : ptr<function, u32>,  place_28 : Place_0)
{
    set_word_0(path_12, (*which_10), place_28.triangle_0);
    set_word_0(path_12, (*which_10) + u32(1), (bitcast<u32>((place_28.v_0))));
    set_word_0(path_12, (*which_10) + u32(2), (bitcast<u32>((place_28.w_0))));
    set_word_0(path_12, (*which_10) + u32(3), (bitcast<u32>((place_28.v_rest_0))));
    set_word_0(path_12, (*which_10) + u32(4), (bitcast<u32>((place_28.w_rest_0))));
    (*which_10) = (*which_10) + u32(5);
    return;
}

fn set_place_1( path_13 : u32,  which_11 : ptr<function, u32>,  place_29 : Place_0)
{
    set_word_0(path_13, (*which_11), place_29.triangle_0);
    set_word_0(path_13, (*which_11) + u32(1), (bitcast<u32>((place_29.v_0))));
    set_word_0(path_13, (*which_11) + u32(2), (bitcast<u32>((place_29.w_0))));
    set_word_0(path_13, (*which_11) + u32(3), (bitcast<u32>((place_29.v_rest_0))));
    set_word_0(path_13, (*which_11) + u32(4), (bitcast<u32>((place_29.w_rest_0))));
    (*which_11) = (*which_11) + u32(5);
    return;
}

fn set_changing_0( path_14 : u32,  which_12 : ptr<function, u32>,  vector_2 : vec3<f32>)
{
    set_vector_2(path_14, &((*which_12)), value_of_0(vector_2));
    return;
}

fn store_0( number_of_path_1 : u32,  path_15 : Path_0)
{
    var at_20 : u32 = u32(1);
    set_vector_0(number_of_path_1, &(at_20), path_15.adjoint_0);
    set_changing_0(number_of_path_1, &(at_20), path_15.throughput_0);
    set_changing_0(number_of_path_1, &(at_20), path_15.direction_1);
    set_place_0(number_of_path_1, &(at_20), path_15.place_3);
    var _S1394 : u32 = at_20 + u32(1);
    set_word_0(number_of_path_1, at_20, path_15.key_0.x);
    at_20 = _S1394 + u32(1);
    set_word_0(number_of_path_1, _S1394, path_15.key_0.y);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S1395 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S1396 : u32 = u32(2) + zero_0;
        _S1395 = _S1396;
        if(rounds_0 < _S1396)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S1395;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S1397 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
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
    var path_16 : Path_0 = load_0(number_of_path_2);
    var importance_3 : vec3<f32> = path_16.adjoint_0 * path_16.throughput_0;
    var direction_31 : vec3<f32> = path_16.direction_1;
    var place_30 : Place_0 = path_16.place_3;
    var reflected_2 : Reflected_0 = nothing_reflected_0();
    var goes_on_2 : bool = take_further_0(&(path_16), &(reflected_2), importance_3);
    var kept_0 : u32 = kept_at_0(launch_0.depth_0);
    set_vector_1(number_of_path_2, &(kept_0), importance_3);
    set_place_1(number_of_path_2, &(kept_0), place_30);
    set_vector_1(number_of_path_2, &(kept_0), direction_31);
    set_vector_1(number_of_path_2, &(kept_0), reflected_2.direct_0);
    set_vector_1(number_of_path_2, &(kept_0), reflected_2.onward_0);
    set_vector_1(number_of_path_2, &(kept_0), reflected_2.wo_0);
    set_vector_1(number_of_path_2, &(kept_0), reflected_2.by_ray_1.drift_0);
    set_vector_1(number_of_path_2, &(kept_0), reflected_2.by_ray_1.direction_0);
    var _S1398 : u32 = kept_0;
    kept_0 = kept_0 + u32(1);
    var _S1399 : i32;
    if(reflected_2.is_specular_0)
    {
        _S1399 = i32(1);
    }
    else
    {
        _S1399 = i32(0);
    }
    set_word_0(number_of_path_2, _S1398, u32(_S1399));
    var _S1400 : u32 = kept_0;
    kept_0 = kept_0 + u32(1);
    var _S1401 : u32;
    if(goes_on_2)
    {
        _S1401 = (bitcast<u32>((reflected_2.factor_0)));
    }
    else
    {
        _S1401 = u32(0);
    }
    set_word_0(number_of_path_2, _S1400, _S1401);
    set_word_0(number_of_path_2, kept_0, (bitcast<u32>((reflected_2.distance_1))));
    path_16.throughput_0 = path_16.throughput_0 * reflected_2.onward_0;
    store_0(number_of_path_2, path_16);
    if(goes_on_2)
    {
        _S1401 = number_of_path_2;
    }
    else
    {
        _S1401 = u32(4294967295);
    }
    set_word_0(at_21, u32(0), _S1401);
    check_loops_0();
    return;
}
